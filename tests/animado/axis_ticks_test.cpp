// src/animado/axis_ticks.cpp
#include "animado/axis_ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace animado {
namespace {

using testing::ElementsAre;

TEST(AxisTicks, AreRound) {
  EXPECT_THAT(ticks_of(0, 3.3, 5).labels, ElementsAre("0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"));
  EXPECT_THAT(ticks_of(-5.9, 8.4, 5).labels, ElementsAre("-4", "-2", "0", "2", "4", "6", "8"));
  EXPECT_THAT(ticks_of(0, 0.95, 5).labels, ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8"));
  EXPECT_THAT(ticks_of(-2, 2, 4).labels, ElementsAre("-2", "-1", "0", "1", "2"));
}

TEST(AxisTicks, LieWithinTheAxisAndAreAHandful) {
  for (const double low : {-1e-15, -3.7, 0.0, 12.0, 1e9}) {
    for (const double length : {1e-9, 0.3, 1.0, 77.0, 1e12}) {
      const Ticks ticks = ticks_of(low, low + length, 5);
      EXPECT_GE(ticks.at.size(), 2u) << low << " " << length;
      EXPECT_LE(ticks.at.size(), 8u) << low << " " << length;
      for (const double at : ticks.at) {
        EXPECT_GE(at, ticks.low - 1e-8 * length);
        EXPECT_LE(at, ticks.high + 1e-8 * length);
      }
    }
  }
}

TEST(AxisTicks, SmallAndLargeNumbersHaveACommonExponent) {
  const Ticks small = ticks_of(0, 4e-15, 4);
  EXPECT_EQ(small.exponent, -15);
  EXPECT_THAT(small.labels, ElementsAre("0", "1", "2", "3", "4"));
  const Ticks large = ticks_of(0, 4e6, 4);
  EXPECT_EQ(large.exponent, 6);
  EXPECT_THAT(large.labels, ElementsAre("0", "1", "2", "3", "4"));
}

TEST(AxisTicks, AConstantIsInTheMiddle) {
  for (const double value : {0.0, 5.0, -1e-20, 1e20}) {
    const Ticks ticks = ticks_of(value, value, 5);
    EXPECT_LT(ticks.low, value);
    EXPECT_GT(ticks.high, value);
    EXPECT_NEAR(ticks.low + ticks.high, 2 * value, 1e-9 * std::abs(value));
  }
}

}  // namespace
}  // namespace animado
