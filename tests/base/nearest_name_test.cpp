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
  // "form" is allowed a distance of 2: "from" needs one exchange, which beats the two changes of "fold".
  const std::vector<std::string> names = {"fold", "from"};
  EXPECT_EQ(nearest_name("form", names), "from");
}

TEST(NearestName, NothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("temperature", kProperties), "");
  EXPECT_EQ(nearest_name("mass", {}), "");
}

TEST(NearestName, TheLimitGrowsWithTheWord) {
  const std::vector<std::string> names = {"abcdef"};
  EXPECT_EQ(nearest_name("xyzdef", names), "abcdef");  // 3 = 6/3 + 1
  EXPECT_EQ(nearest_name("xyzwef", names), "");        // 4
}

TEST(NearestName, TheFirstOfEquals) {
  const std::vector<std::string> names = {"bat", "cat"};
  EXPECT_EQ(nearest_name("hat", names), "bat");
}

}  // namespace
}  // namespace animado
