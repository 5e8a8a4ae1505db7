// src/base/finite.cpp
#include "base/finite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace animado {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Finite, NothingIsWithin) {
  EXPECT_TRUE(all_finite({}));
}

TEST(Finite, WhatIsBeyondIsFoundWhereverItStands) {
  for (size_t count = 1; count < 40; ++count) {
    std::vector<double> numbers(count, -2);
    EXPECT_TRUE(all_finite(numbers));
    EXPECT_TRUE(all_within(numbers, 2));
    for (size_t i = 0; i < count; ++i) {
      for (double bad : {kInfinity, -kInfinity, kNaN, -kNaN}) {
        numbers[i] = bad;
        EXPECT_FALSE(all_finite(numbers)) << bad << " in " << i << " of " << count;
        EXPECT_FALSE(all_within(numbers, 2)) << bad << " in " << i << " of " << count;
      }
      for (double beyond : {std::nextafter(2, 3), std::nextafter(-2, -3)}) {
        numbers[i] = beyond;
        EXPECT_TRUE(all_finite(numbers));
        EXPECT_FALSE(all_within(numbers, 2)) << beyond << " in " << i << " of " << count;
      }
      numbers[i] = 2;
    }
  }
}

TEST(Finite, TheLargestAndTheSmallestNumbersAreFinite) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(all_finite(std::vector<double>{most, -most, least, -least, 0, -0.0, most, -most, least}));
}

}  // namespace
}  // namespace animado
