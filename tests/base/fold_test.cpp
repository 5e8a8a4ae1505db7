// src/base/fold.cpp
#include "base/fold.hpp"

#include <gtest/gtest.h>

namespace animado {
namespace {

TEST(Fold, CaseDoesNotMatter) {
  EXPECT_EQ(fold("Massa DO Cubo_2"), "massa do cubo_2");
}

TEST(Fold, AccentsDoNotMatter) {
  EXPECT_EQ(fold("inclinação"), "inclinacao");
  EXPECT_EQ(fold("INÉRCIA"), "inercia");
  EXPECT_EQ(fold("àáâãäå ç èéêë ìíîï ñ òóôõö ùúûü ý"), "aaaaaa c eeee iiii n ooooo uuuu y");
}

TEST(Fold, KeepsColumns) {
  EXPECT_EQ(fold("a×b"), "a?b");      // U+00D7 is no letter
  EXPECT_EQ(fold("π=3"), "?=3");      // two bytes
  EXPECT_EQ(fold("5 €"), "5 ?");      // three bytes
  EXPECT_EQ(fold("🎱ball"), "?ball");  // four bytes
}

TEST(Fold, SurvivesWhatIsNotUtf8) {
  EXPECT_EQ(fold("\xFF"), "?");
  EXPECT_EQ(fold("a\xC3"), "a?");        // cut short
  EXPECT_EQ(fold("\xA1x"), "?x");        // a continuation that continues nothing
  EXPECT_EQ(fold("\xE2x\ny"), "?x\ny");  // a lead without its continuation takes nothing with it
  EXPECT_EQ(fold("\xC3(ab)"), "?(ab)");
}

}  // namespace
}  // namespace animado
