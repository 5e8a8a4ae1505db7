// src/egesp/determinant.cpp: determinants known in closed form.
#include "egesp/determinant.hpp"

#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

double of(std::vector<double> a, size_t n, PivotRule rule = {}) {
  return determinant(a, n, rule);
}

TEST(Determinant, OfSmallIntegers) {
  EXPECT_EQ(of({7}, 1), 7);
  EXPECT_DOUBLE_EQ(of({1, 2, 3, 4}, 2), -2);
  EXPECT_DOUBLE_EQ(of({2, 0, 1, 1, 3, 2, 1, 1, 4}, 3), 18);
}

TEST(Determinant, ChangesItsSignWithEachExchange) {
  EXPECT_EQ(of({0, 1, 1, 0}, 2), -1);
  EXPECT_EQ(of({0, 1, 0, 0, 0, 1, 1, 0, 0}, 3), 1);  // a cycle of three rows is an even permutation
  EXPECT_EQ(of({0, 1, 0, 0, 0, 1, 1, 0, 0}, 3, {.complete = true}), 1);
}

TEST(Determinant, OfASingularMatrixIsZero) {
  EXPECT_EQ(of({1, 2, 3, 4, 5, 6, 7, 8, 9}, 3), 0);
  EXPECT_EQ(of({0, 0, 0, 0}, 2), 0);
}

// det H₅ = 1/266716800000; relative error within its condition number (4.8e5) times a few roundings.
TEST(Determinant, OfHilbertFive) {
  EXPECT_NEAR(of(hilbert(5), 5) * 266716800000.0, 1, 4.8e5 * 5 * 0x1p-53);
}

// On the way the product passes 1e±450, beyond the doubles; T = 1e-310 keeps the small pivots.
TEST(Determinant, MayPassBeyondTheRangeOfDoubles) {
  const auto diagonal = [](std::vector<double> values) {
    const size_t n = values.size();
    std::vector<double> a(n * n);
    for (size_t i = 0; i < n; ++i) a[i * n + i] = values[i];
    return of(a, n, {.complete = false, .threshold = 1e-310});
  };
  EXPECT_NEAR(diagonal({1e150, 1e150, 1e150, 1e-150, 1e-150, 1e-150}), 1, 1e-15);
  EXPECT_NEAR(diagonal({1e-150, 1e-150, 1e-150, 1e150, 1e150, 1e150}), 1, 1e-15);
  EXPECT_EQ(diagonal({1e200, -1e200}), -HUGE_VAL);
}

}  // namespace
}  // namespace animado::egesp
