// src/base/nearest_name.cpp
#include "base/nearest_name.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace animado {
namespace {

const std::vector<std::string> kProperties = {"mass", "motion", "friction", "velocity", "position"};

TEST(NearestName, OneSlipOfEachKind) {
  EXPECT_EQ(nearest_name("frction", kProperties), "friction");    // left out
  EXPECT_EQ(nearest_name("friiction", kProperties), "friction");  // doubled
  EXPECT_EQ(nearest_name("frixtion", kProperties), "friction");   // another key
  EXPECT_EQ(nearest_name("frcition", kProperties), "friction");   // exchanged
}

TEST(NearestName, AnExchangeIsOneSlip) {
  // "formal" is allowed a distance of 2: "fromal" needs one exchange, which beats the two changes of
  // "foldal".
  const std::vector<std::string> names = {"foldal", "fromal"};
  EXPECT_EQ(nearest_name("formal", names), "fromal");
}

TEST(NearestName, NothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("temperature", kProperties), "");
  EXPECT_EQ(nearest_name("mass", {}), "");
}

TEST(NearestName, TheLimitGrowsWithTheWord) {
  const std::vector<std::string> names = {"abcdef"};
  EXPECT_EQ(nearest_name("xycdef", names), "abcdef");  // 2 = 6/3
  EXPECT_EQ(nearest_name("xyzdef", names), "");        // 3
}

TEST(NearestName, InAShortWordOneSlip) {
  const std::vector<std::string> names = {"log", "x"};
  EXPECT_EQ(nearest_name("lgo", names), "log");
  EXPECT_EQ(nearest_name("bogus", names), "");
  EXPECT_EQ(nearest_name("xx", names), "x");
  EXPECT_EQ(nearest_name("y", names), "") << "one letter in place of another is nothing alike";
}

TEST(NearestName, TheFirstOfEquals) {
  const std::vector<std::string> names = {"bat", "cat"};
  EXPECT_EQ(nearest_name("hat", names), "bat");
}

}  // namespace
}  // namespace animado
