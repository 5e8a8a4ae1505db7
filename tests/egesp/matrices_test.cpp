// One suite over every way that EGESP has to solve a dense system, and every matrix with a reputation: each
// solution within a stated bound.
//
// The bound on the backward error η is Wilkinson's in the form that holds in practice,
//
//   η ≤ 4 n u ρ,    ρ = max |u_ij| / max |a_ij|  (measured),   u = 2⁻⁵³
//
// (his theorem has n³; Higham 2002, theorem 9.5 and the discussion after it), and each family states how
// large ρ may become under partial pivoting. Under complete pivoting it is Wilkinson's √n (2 · 3^(1/2) ·
// 4^(1/3) … n^(1/(n−1)))^(1/2).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "egesp/accuracy.hpp"
#include "egesp/batch.hpp"
#include "egesp/dense_system.hpp"
#include "egesp/gauss_jordan.hpp"
#include "egesp/invert.hpp"
#include "egesp/least_squares.hpp"
#include "matrices.hpp"

namespace animado::egesp {
namespace {

struct Family {
  const char* name;
  Numbers (*matrix)(size_t n);
  std::vector<size_t> sizes;
  double (*growth)(double n);  // the bound on ρ under partial pivoting
};

// Without exchanges nothing grows in a totally positive matrix; what partial pivoting exchanges may at most
// double here.
double at_most_two(double) {
  return 2;
}
const Family kFamilies[] = {
    {"Hilbert", hilbert, {2, 6, 12, 20, 60}, at_most_two},
    {"Wilkinson", wilkinson, {2, 10, 32, 50}, [](double n) { return std::pow(2, n - 1); }},
    {"Kahan", kahan, {5, 30, 90}, [](double) { return 1.0; }},  // triangular
    {"Vandermonde", vandermonde, {4, 12, 25, 60}, at_most_two},
    {"Pascal", pascal, {5, 15, 30}, at_most_two},
    {"Frank", frank, {6, 32, 100}, [](double n) { return n; }},  // Hessenberg
    {"Toeplitz", toeplitz, {8, 32, 150}, at_most_two},           // positive definite
    {"SecondDifference", second_difference, {8, 32, 150}, at_most_two},
    {"Random",
     random_matrix,
     {1, 7, 15, 32, 33, 64, 100, 257},
     [](double n) { return 2 * std::pow(n, 2.0 / 3); }},
    {"DiagonallyDominant", diagonally_dominant, {4, 32, 130}, at_most_two},
    {"Graded", graded, {6, 32, 130}, [](double n) { return 2 * std::pow(n, 2.0 / 3); }},
};

double wilkinsons_bound(double n) {
  double product = 1;
  for (double k = 2; k <= n; ++k) product *= std::pow(k, 1 / (k - 1));
  return std::sqrt(n * product);
}

double largest(const Numbers& numbers) {
  double size = 0;
  for (double v : numbers) size = std::max(size, std::abs(v));
  return size;
}

class EveryFamily : public testing::TestWithParam<std::tuple<Family, bool>> {
 protected:
  const Family& family() const { return std::get<0>(GetParam()); }
  bool complete() const { return std::get<1>(GetParam()); }
  PivotRule rule() const {
    return {complete(), 1e-300};
  }  // nothing but zero is refused: these are hard on purpose
};

std::string test_name(const testing::TestParamInfo<std::tuple<Family, bool>>& tested) {
  return std::get<0>(tested.param).name + std::string(std::get<1>(tested.param) ? "Complete" : "Partial");
}

INSTANTIATE_TEST_SUITE_P(, EveryFamily, testing::Combine(testing::ValuesIn(kFamilies), testing::Bool()),
                         test_name);

TEST_P(EveryFamily, GrowsNoMoreThanIsProved) {
  for (const size_t n : family().sizes) {
    const Numbers a = family().matrix(n);
    const double growth = Lu(a, n, rule()).largest_factor() / largest(a);
    const auto size = static_cast<double>(n);
    EXPECT_LE(growth, (complete() ? wilkinsons_bound(size) : family().growth(size)) * (1 + size * kUnit))
        << n;
  }
}

TEST_P(EveryFamily, IsSolvedWithinTheBoundByEveryMethod) {
  for (const size_t n : family().sizes) {
    const Numbers a = family().matrix(n);
    Uniform uniform;
    const Numbers b = random_numbers(uniform, n);
    const DenseSystem system(a, n, rule());
    ASSERT_TRUE(system.lu().factored()) << n;
    const double growth = std::max(1.0, system.lu().largest_factor() / largest(a));
    const double bound = 4 * static_cast<double>(n) * kUnit * growth;
    const auto error = [&](const Numbers& x) { return backward_error(a.data(), b.data(), x.data(), n, 1); };

    Numbers factors = a, swept = b;
    ASSERT_TRUE(gauss_jordan(factors, swept, n, 1, rule()).solved()) << n;
    EXPECT_LE(error(swept), bound) << "Gauss-Jordan " << n;

    Numbers batched(n);
    EXPECT_TRUE(solve_batch({a, b, batched, 1, n, 1}, rule()).empty()) << n;
    EXPECT_EQ(batched, swept) << "a batch has the bits of one " << n;

    Numbers x = b;
    system.solve(x, 1);
    EXPECT_EQ(x, swept) << "so have the factors " << n;

    refine(system, b, x, 1);
    EXPECT_LE(error(x), std::max(error(swept), 2 * kUnit)) << "refined " << n;
  }
}

TEST(Matrices, WilkinsonReachesItsGrowthAndCompletePivotingDoesNot) {
  for (const size_t n : {10, 50}) {
    EXPECT_EQ(Lu(wilkinson(n), n, {}).largest_factor(), std::pow(2.0, static_cast<double>(n - 1)));
    EXPECT_LE(Lu(wilkinson(n), n, {.complete = true}).largest_factor(), 2);
  }
}

// One step of refinement takes back what a growth of 2²⁹ has lost.
TEST(Matrices, RefinementMendsWilkinson) {
  constexpr size_t n = 30;
  const Numbers a = wilkinson(n);
  Uniform uniform;
  const Numbers b = random_numbers(uniform, n);
  const DenseSystem system(a, n, {});
  Numbers x = b;
  system.solve(x, 1);
  EXPECT_GT(backward_error(a.data(), b.data(), x.data(), n, 1), 1e-10);
  refine(system, b, x, 1);
  EXPECT_LT(backward_error(a.data(), b.data(), x.data(), n, 1), 1e-15);
}

double determinant_of(const Numbers& a, size_t n) {
  return Lu(a, n, {.threshold = 1e-300}).determinant();
}

// Relative error of a determinant: n u κ at most (Higham 2002, problem 14.14); κ is left to each line.
TEST(Matrices, DeterminantsAreKnown) {
  EXPECT_NEAR(determinant_of(pascal(8), 8), 1, 8 * kUnit * 2e7);
  EXPECT_NEAR(determinant_of(frank(8), 8), 1, 8 * kUnit * 1e5);
  EXPECT_NEAR(determinant_of(second_difference(200), 200) / 201, 1, 200 * kUnit * 2e4);
  EXPECT_NEAR(determinant_of(toeplitz(100), 100) / std::pow(0.75, 99), 1, 100 * kUnit * 9);
  EXPECT_NEAR(determinant_of(wilkinson(20), 20) / std::pow(2.0, 19), 1, 20 * kUnit);
  double product = 1;  // Π (x_j − x_i)
  for (size_t j = 0; j < 9; ++j) {
    for (size_t i = 0; i < j; ++i) product *= vandermonde_point(9, j) - vandermonde_point(9, i);
  }
  EXPECT_NEAR(determinant_of(vandermonde(9), 9) / product, 1, 9 * kUnit * 1e8);
}

// ‖X − A⁻¹‖ / ‖A⁻¹‖ ≤ n u κ for an inverse by columns (Higham 2002, section 14.3).
void expect_inverse(const Numbers& a, size_t n, const Numbers& exact) {
  Numbers used = a, inverse(n * n);
  ASSERT_TRUE(invert(used, inverse, n, {.threshold = 1e-300}).solved());
  const double condition = 1 / reciprocal_condition(DenseSystem(a, n, {.threshold = 1e-300}));
  for (size_t e = 0; e < n * n; ++e)
    EXPECT_NEAR(inverse[e], exact[e], static_cast<double>(n) * kUnit * condition * largest(exact))
        << n << " " << e;
}

TEST(Matrices, InversesAreKnown) {
  constexpr size_t n = 100;
  expect_inverse(second_difference(n), n, filled(n, [](double i, double j) {
                   return std::min(i, j) + 1 - (i + 1) * (j + 1) / (static_cast<double>(n) + 1);
                 }));
  expect_inverse(toeplitz(n), n, filled(n, [](double i, double j) {
                   if (std::abs(i - j) == 1) return -0.5 / 0.75;
                   if (i != j) return 0.0;
                   return i == 0 || i == static_cast<double>(n) - 1 ? 1 / 0.75 : 1.25 / 0.75;
                 }));
  // H⁻¹_ij = (−1)^(i+j) (i+j−1) C(n+i−1, n−j) C(n+j−1, n−i) C(i+j−2, i−1)², counted from 1.
  const auto binomial = [](double m, double k) {
    return std::round(std::exp(std::lgamma(m + 1) - std::lgamma(k + 1) - std::lgamma(m - k + 1)));
  };
  expect_inverse(hilbert(6), 6, filled(6, [&](double i, double j) {
                   const double sign = std::fmod(i + j, 2) == 0 ? 1 : -1, c = binomial(i + j, i);
                   return sign * (i + j + 1) * binomial(6 + i, 5 - j) * binomial(6 + j, 5 - i) * c * c;
                 }));
}

// Kahan's matrix has a singular value below 1e-8 of the first, and no small element tells: column pivoting
// calls it of full rank even with T = 1e-6, as documented; the condition estimate is not deceived.
TEST(Matrices, KahanDeceivesTheRankAndNotTheCondition) {
  constexpr size_t n = 90;
  const Numbers a = kahan(n), b(n, 1.0);
  EXPECT_EQ(least_squares({a, b, n, n, 1, 1e-6}).rank, n);
  EXPECT_LT(reciprocal_condition(DenseSystem(a, n, {.threshold = 1e-300})), 1e-15);
}

// Scaled by powers of ten from row to row, a dominant matrix is solved as if it were not: n u κ with the κ of
// the unscaled one, below 10.
TEST(Matrices, GradingByRowsCostsNoDigits) {
  constexpr size_t n = 60;
  const Numbers a = graded(n);
  Numbers factors = a, b(n), x;
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) b[i] += a[i * n + j];
  }
  x = b;
  ASSERT_TRUE(gauss_jordan(factors, x, n, 1, {.threshold = 1e-300}).solved());
  for (double v : x) EXPECT_NEAR(v, 1, n * kUnit * 10);
}

}  // namespace
}  // namespace animado::egesp
