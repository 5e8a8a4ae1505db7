// src/egesp/gauss_jordan.cpp: systems solved by hand, hard ones within the bounds of the literature, and the
// refusals.
#include "egesp/gauss_jordan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

struct Solved {
  Elimination outcome;
  std::vector<double> x;
};

Solved solve(std::vector<double> a, std::vector<double> b, size_t n, size_t m, PivotRule rule = {}) {
  const Elimination outcome = gauss_jordan(a, b, n, m, rule);
  return {outcome, b};
}

class BothPivotings : public testing::TestWithParam<bool> {
 protected:
  PivotRule rule(double threshold = 0) const { return {GetParam(), threshold}; }
};

INSTANTIATE_TEST_SUITE_P(, BothPivotings, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "complete" : "partial"; });

TEST_P(BothPivotings, SolvesBySmallIntegersExactly) {
  const auto [outcome, x] = solve({2, 1, -1, -3, -1, 2, -2, 1, 2}, {8, -11, -3}, 3, 1, rule());
  EXPECT_TRUE(outcome.solved());
  EXPECT_NEAR(outcome.determinant, -1, 1e-15);
  EXPECT_THAT(x, Pointwise(DoubleNear(1e-14), {2, 3, -1}));
}

TEST_P(BothPivotings, FindsAPivotWhereTheFirstIsZero) {
  const auto [outcome, x] = solve({0, 1, 0, 0, 0, 2, 4, 0, 0}, {5, 6, 8}, 3, 1, rule());
  EXPECT_TRUE(outcome.solved());
  EXPECT_THAT(x, ElementsAre(2, 5, 3));
  EXPECT_EQ(outcome.determinant, 8);
}

TEST_P(BothPivotings, GrowthOfATinyPivotIsAvoided) {
  const auto [outcome, x] = solve({1e-14, 1, 1, 1}, {1, 2}, 2, 1, rule());
  EXPECT_TRUE(outcome.solved());
  EXPECT_THAT(x, Pointwise(DoubleNear(2e-14), {1, 1}));
}

TEST_P(BothPivotings, SolvesSeveralRightSidesAtOnce) {
  const std::vector<double> a{4, -2, 1, 3};  // det 14
  const auto [outcome, x] = solve(a, {2, 0, 14, 4, 14, 0}, 2, 3, rule());
  EXPECT_TRUE(outcome.solved());
  EXPECT_THAT(x, Pointwise(DoubleNear(1e-15), {1.0, 2.0, 3.0, 1.0, 4.0, -1.0}));
}

// Gaussian elimination with pivoting is backward stable here whatever the condition: n = 12 has a condition
// number of 1.7e16, yet the residual stays at a few roundings (Higham 2002, theorem 9.3 with the growth
// factor 1 of these matrices).
TEST_P(BothPivotings, HilbertSystemsHaveSmallResiduals) {
  for (size_t n = 2; n <= 12; ++n) {
    const std::vector<double> a = hilbert(n), b(n, 1.0);
    const auto [outcome, x] = solve(a, b, n, 1, rule(1e-300));
    ASSERT_TRUE(outcome.solved()) << n;
    EXPECT_LT(backward_error(a.data(), b.data(), x.data(), n, 1), static_cast<double>(n) * kUnit) << n;
  }
}

// x of H x = 1 is known: x_i = (−1)^(n+i−1) (n+i)! / … is integer; for n = 6: −6, 210, −1680, 5040, −6300,
// 2772. Condition 1.5e7.
TEST_P(BothPivotings, HilbertSixIsSolvedToItsCondition) {
  const auto [outcome, x] = solve(hilbert(6), std::vector<double>(6, 1.0), 6, 1, rule());
  const double exact[] = {-6, 210, -1680, 5040, -6300, 2772};
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(x[i], exact[i], 1.5e7 * 6 * kUnit * 6300);
}

TEST_P(BothPivotings, RandomSystemsOfEverySizeFit) {
  Uniform uniform;
  for (size_t n : {1, 2, 3, 7, 31, 32, 33, 64, 100, 257}) {
    for (size_t m : {1, 3}) {
      const auto a = random_numbers(uniform, n * n), b = random_numbers(uniform, n * m);
      const auto [outcome, x] = solve(a, b, n, m, rule());
      ASSERT_TRUE(outcome.solved()) << n;
      EXPECT_LT(backward_error(a.data(), b.data(), x.data(), n, m), 8 * kUnit) << n << "x" << m;
    }
  }
}

TEST_P(BothPivotings, ASingularSystemNamesThePivot) {
  const std::vector<double> a{1, 2, 3, 4, 5, 6, 7, 8, 9};  // row 3 = 2 · row 2 − row 1
  const auto [outcome, x] = solve(a, {1, 2, 3}, 3, 1, rule());
  EXPECT_FALSE(outcome.solved());
  EXPECT_EQ(outcome.pivots, 2u);
  EXPECT_EQ(outcome.determinant, 0);
}

TEST_P(BothPivotings, ZeroMatrixAndTinyMatrixAreRefusedAtOnce) {
  EXPECT_EQ(solve({0, 0, 0, 0}, {1, 1}, 2, 1, rule()).outcome.pivots, 0u);
  EXPECT_EQ(solve({5e-324, 0, 0, 5e-324}, {1, 1}, 2, 1, rule()).outcome.pivots,
            0u);  // 1/pivot would overflow
}

TEST_P(BothPivotings, ThresholdDecidesWhatIsSingular) {
  const std::vector<double> a{1, 0, 0, 1e-6}, b{1, 1};
  EXPECT_TRUE(solve(a, b, 2, 1, rule(1e-7)).outcome.solved());
  EXPECT_EQ(solve(a, b, 2, 1, rule(1e-6)).outcome.pivots, 1u);  // not larger than T · 1
  EXPECT_EQ(solve(a, b, 2, 1, rule(1e-5)).outcome.pivots, 1u);
}

TEST_P(BothPivotings, OverflowIsNotASolution) {
  const auto [outcome, x] = solve({1e-200, 0, 0, 1e-200}, {1e200, 0}, 2, 1, rule());
  EXPECT_EQ(outcome.pivots, 2u);
  EXPECT_FALSE(outcome.solved());
}

TEST_P(BothPivotings, NumbersThatAreNotFiniteAreRefused) {
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (size_t place = 0; place < 6; ++place) {
      std::vector<double> a{2, 1, 1, 3}, b{1, 1};
      (place < 4 ? a[place] : b[place - 4]) = bad;
      EXPECT_FALSE(solve(a, b, 2, 1, rule()).outcome.solved()) << bad << " at " << place;
    }
  }
}

// Wilkinson's matrix: partial pivoting lets the last column double at every step, complete pivoting does not.
TEST(GaussJordan, CompletePivotingStopsTheGrowthThatPartialPivotingAllows) {
  constexpr size_t n = 60;
  std::vector<double> a(n * n), b(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) a[i * n + j] = j == n - 1 || i == j ? 1 : i > j ? -1 : 0;
    b[i] = std::sin(static_cast<double>(i));
  }
  const auto partial = solve(a, b, n, 1), complete = solve(a, b, n, 1, {.complete = true});
  EXPECT_GT(backward_error(a.data(), b.data(), partial.x.data(), n, 1), 1e-6);
  EXPECT_LT(backward_error(a.data(), b.data(), complete.x.data(), n, 1), 1e-15);
}

}  // namespace
}  // namespace animado::egesp
