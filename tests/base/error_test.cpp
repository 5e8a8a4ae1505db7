// src/base/error.cpp
#include "base/error.hpp"

#include <gtest/gtest.h>

#include <set>

namespace animado {
namespace {

TEST(Error, EveryCodeHasAName) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Code::internal); ++i) {
    const auto code = static_cast<Code>(i);
    EXPECT_EQ(code_named(name_of(code)), code);
    names.insert(name_of(code));
  }
  EXPECT_EQ(names.size(), static_cast<size_t>(Code::internal) + 1);
}

TEST(Error, SpellingIsPartOfTheProtocol) {
  EXPECT_EQ(name_of(Code::protocol), "protocol");
  EXPECT_EQ(name_of(Code::bad_shape), "bad_shape");
  EXPECT_EQ(name_of(Code::not_finite), "not_finite");
  EXPECT_EQ(name_of(Code::unknown_handle), "unknown_handle");
  EXPECT_EQ(name_of(Code::internal), "internal");
}

TEST(Error, AnUnknownNameIsABugOfTheOtherSide) {
  EXPECT_EQ(code_named("no_such_code"), Code::internal);
}

TEST(Error, TellsPlaceAndRemedy) {
  const Error error(Code::refused, "mass is 0", "top.animado:3:6", "give a positive mass");
  EXPECT_STREQ(error.what(), "top.animado:3:6: mass is 0\n  give a positive mass");
  EXPECT_EQ(error.code(), Code::refused);
  EXPECT_EQ(error.message(), "mass is 0");
  EXPECT_EQ(error.where(), "top.animado:3:6");
  EXPECT_EQ(error.remedy(), "give a positive mass");
}

TEST(Error, LeavesOutWhatIsEmpty) {
  EXPECT_STREQ(Error(Code::limit, "too long").what(), "too long");
}

}  // namespace
}  // namespace animado
