// src/fred/lanes.cpp: the same bits whatever the width of a register, and those of the sum in its stated
// order.
#include "fred/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace animado::fred {
namespace {

TEST(Lanes, HaveTheSameBitsOnEveryInstructionSet) {
  constexpr size_t kSize = 24;
  alignas(64) static double rows[kMostTerms + 4][kSize];
  for (size_t r = 0; r < kMostTerms + 4; ++r) {
    for (size_t i = 0; i < kSize; ++i) rows[r][i] = std::sin(static_cast<double>(7 * r + 3 * i) + 0.1);
  }
  const double* k[kMostTerms];
  for (size_t j = 0; j < kMostTerms; ++j) k[j] = rows[j];
  const double *y = rows[kMostTerms], *end = rows[kMostTerms + 1];
  double *narrow = rows[kMostTerms + 2], *wide = rows[kMostTerms + 3];
  const double absolute = 1e-3, relative = 1e-2;
  for (int count = 1; count <= kMostTerms; ++count) {
    Sum sum;
    sum.count = count;
    for (int j = 0; j < count; ++j) {
      sum.rows[j] = static_cast<unsigned char>(kMostTerms - 1 - j);
      sum.coefficients[j] = std::cos(j + 0.3);
    }
    const auto at = static_cast<size_t>(count);
    kLanesSse2.combine[at](y, k, sum, 0.1, narrow, kSize);
    for (size_t i = 0; i < kSize; ++i) {
      double total = sum.coefficients[0] * k[sum.rows[0]][i];
      for (int j = 1; j < count; ++j) total += sum.coefficients[j] * k[sum.rows[j]][i];
      EXPECT_EQ(narrow[i], y[i] + 0.1 * total);
    }
    if (!__builtin_cpu_supports("avx2")) continue;
    kLanesAvx2.combine[at](y, k, sum, 0.1, wide, kSize);
    EXPECT_EQ(std::vector(narrow, narrow + kSize), std::vector(wide, wide + kSize));
    const ErrorScale scale = {&absolute, &relative, 0};
    EXPECT_EQ(kLanesSse2.square_error[at](y, end, k, sum, scale, kSize),
              kLanesAvx2.square_error[at](y, end, k, sum, scale, kSize));
  }
}

}  // namespace
}  // namespace animado::fred
