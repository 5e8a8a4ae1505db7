// src/egesp/accuracy.cpp: errors made on purpose are seen at their size, conditions known in closed form are
// estimated, and a step of refinement does what is proved of it.
#include "egesp/accuracy.hpp"

#include <gtest/gtest.h>

#include "egesp/dense_system.hpp"
#include "systems.hpp"

namespace animado::egesp {
namespace {

TEST(Accuracy, SeesABackwardErrorAtItsSize) {
  const std::vector<double> a{2, 0, 0, 4}, b{2, 8, 4, 8};  // two right-hand sides, x = (1, 4; 1, 2)
  const DenseSystem system(a, 2, {});
  EXPECT_EQ(backward_error(system, b, std::vector<double>{1, 4, 1, 2}, 2), 0);
  // Of the second, x₁ = 4 + 1/8: r = −1/4, ‖A‖ = 4, ‖x‖ = 4.125, ‖b‖ = 8.
  EXPECT_DOUBLE_EQ(backward_error(system, b, std::vector<double>{1, 4.125, 1, 2}, 2), 0.25 / (4 * 4.125 + 8));
}

TEST(Accuracy, ZeroSolvesZero) {
  const std::vector<double> a{1, 0, 0, 1}, zero{0, 0};
  EXPECT_EQ(backward_error(DenseSystem(a, 2, {}), zero, zero, 1), 0);
}

TEST(Accuracy, ConditionOfADiagonalIsExact) {
  const std::vector<double> a{8, 0, 0, 0, -1, 0, 0, 0, 0.25};
  EXPECT_DOUBLE_EQ(reciprocal_condition(DenseSystem(a, 3, {})), 0.25 / 8);
  const std::vector<double> one{5};
  EXPECT_DOUBLE_EQ(reciprocal_condition(DenseSystem(one, 1, {})), 1);
}

// ‖H‖₁ ‖H⁻¹‖₁ from the integer inverses of the Hilbert matrices.
TEST(Accuracy, ConditionOfHilbertMatricesIsEstimated) {
  const std::pair<size_t, double> known[] = {{3, 748}, {5, 943656}, {7, 985194886.5}};
  for (const auto& [n, condition] : known) {
    const auto a = hilbert(n);
    EXPECT_NEAR(1 / reciprocal_condition(DenseSystem(a, n, {.threshold = 1e-300})) / condition, 1, 1e-6) << n;
  }
}

// The estimate is a lower bound of κ and, on random matrices, within a factor of 3 of it.
TEST(Accuracy, ConditionOfRandomMatricesIsWithinAFactorOfThree) {
  Uniform uniform;
  for (const size_t n : {2, 5, 20, 60}) {
    const auto a = random_numbers(uniform, n * n);
    const DenseSystem system(a, n, {});
    double inverse_norm = 0;
    for (size_t j = 0; j < n; ++j) {
      std::vector<double> column(n);
      column[j] = 1;
      system.solve(column, 1);
      double sum = 0;
      for (double v : column) sum += std::abs(v);
      inverse_norm = std::max(inverse_norm, sum);
    }
    const double condition = system.norm_one() * inverse_norm, estimate = 1 / reciprocal_condition(system);
    EXPECT_LE(estimate, condition * (1 + 1e-12)) << n;
    EXPECT_GE(estimate, condition / 3) << n;
  }
}

// With a residual of more digits one step brings the forward error of a moderately conditioned system to a
// few roundings (Higham 2002, theorem 12.1): H₆ has κ = 2.9e7, without refinement about 8 digits are lost.
TEST(Accuracy, RefinementRecoversTheDigitsOfHilbertSix) {
  const auto a = hilbert(6);
  const std::vector<double> b(6, 1.0), exact{-6, 210, -1680, 5040, -6300, 2772};
  const DenseSystem system(a, 6, {});
  auto x = b;
  system.solve(x, 1);
  // The matrix in the machine is not Hilbert's: its own solution, by several steps, is what one step must
  // meet.
  auto best = x;
  for (int step = 0; step < 5; ++step) refine(system, b, best, 1);
  const auto distance = [&](const std::vector<double>& v) {
    double largest = 0;
    for (size_t i = 0; i < 6; ++i) largest = std::max(largest, std::abs(v[i] / best[i] - 1));
    return largest;
  };
  const double before = distance(x);
  refine(system, b, x, 1);
  EXPECT_GT(before, 1e-12);
  EXPECT_LT(distance(x), before / 100);
}

// A threshold of pivoting that is spoilt on purpose: a solution 1e-3 off is mended.
TEST(Accuracy, RefinementMendsWhatIsOff) {
  Uniform uniform;
  constexpr size_t n = 80, m = 2;
  const auto a = random_numbers(uniform, n * n), b = random_numbers(uniform, n * m);
  const DenseSystem system(a, n, {});
  auto x = b;
  system.solve(x, m);
  for (double& v : x) v *= 1 + 1e-3 * uniform(-1, 1);
  ASSERT_GT(backward_error(system, b, x, m), 1e-6);
  refine(system, b, x, m);
  EXPECT_LT(backward_error(system, b, x, m), 1e-15);
}

TEST(Accuracy, RefinementLeavesWhatItCannotMend) {
  const std::vector<double> a{4, 0, 0, 2}, b{4, 4};
  std::vector<double> x{1, 2};
  refine(DenseSystem(a, 2, {}), b, x, 1);
  EXPECT_EQ(x, (std::vector<double>{1, 2}));
}

}  // namespace
}  // namespace animado::egesp
