// src/interexpserv/expression_error.cpp
#include "interexpserv/expression_error.hpp"

#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

TEST(ExpressionError, CaretCountsCodePoints) {
  const ExpressionError error(Code::syntax, "no", "ação + ?", 7, "f:1", "");
  EXPECT_EQ(error.message(), "no\n  ação + ?\n         ^");
  EXPECT_EQ(error.column(), 7u);
  EXPECT_EQ(error.what_is_wrong(), "no");
}

TEST(ExpressionError, NeverWithoutARemedy) {
  EXPECT_EQ(ExpressionError(Code::syntax, "no", "?", 0, "", "do").remedy(), "do");
  EXPECT_EQ(ExpressionError(Code::syntax, "no", "?", 0, "", "").remedy(),
            "docs/expressions.md lists what can be written");
}

TEST(ExpressionError, LineBreaksDoNotMoveTheCaret) {
  const ExpressionError error(Code::syntax, "no", "1 +\n\t?", 5, "", "");
  EXPECT_EQ(error.message(), "no\n  1 +  ?\n       ^");
}

TEST(ExpressionError, LongTextsAreCutAroundTheCaret) {
  const std::string text(1000, '1');
  const ExpressionError error(Code::syntax, "no", text, 500, "", "");
  const std::string around = "  …" + std::string(100, '1') + "…\n  " + std::string(61, ' ') + "^";
  EXPECT_EQ(error.message(), "no\n" + around);
}

TEST(ExpressionError, WithinADefinitionKeepsTheTextAtFault) {
  const ExpressionError inner(Code::type, "no", "1 + x", 4, "a", "do");
  const ExpressionError outer = inner.within("a", 9, "f:1").within("b", 2, "f:2");
  EXPECT_EQ(outer.message(), "in the definition of `a`: no\n  1 + x\n      ^");
  EXPECT_EQ(outer.column(), 2u);
  EXPECT_EQ(outer.where(), "f:2");
  EXPECT_EQ(outer.remedy(), "do");
  EXPECT_EQ(outer.code(), Code::type);
}

}  // namespace
}  // namespace animado::interexpserv
