// src/live/token.cpp
#include "live/token.hpp"

#include <gtest/gtest.h>

namespace animado::live {
namespace {

TEST(Token, IsAnotherEachTime) {
  const std::string token = random_token();
  EXPECT_EQ(token.size(), 32);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, random_token());
}

TEST(Token, IsTheSameOnlyWhole) {
  EXPECT_TRUE(same_token("0123", "0123"));
  EXPECT_TRUE(same_token("", ""));
  const std::string_view whole = "0123", part = whole.substr(0, 3);  // behind which the rest stands
  EXPECT_FALSE(same_token(whole, part));
  EXPECT_FALSE(same_token(part, whole));
  for (const char* other : {"", "012", "01234", "1123", "0124", "3210"}) {
    EXPECT_FALSE(same_token("0123", other)) << other;
    EXPECT_FALSE(same_token(other, "0123")) << other;
  }
}

}  // namespace
}  // namespace animado::live
