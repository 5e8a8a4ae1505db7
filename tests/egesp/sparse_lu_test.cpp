// src/egesp/sparse_lu.cpp: the sparse factors solve what the dense ones solve, stay sparse, take new values,
// and say what is singular.
#include "egesp/sparse_lu.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "egesp/accuracy.hpp"
#include "egesp/lu.hpp"
#include "systems.hpp"

namespace animado::egesp {
namespace {

using testing::HasSubstr;

std::vector<double> dense(const SparseMatrix& a) {
  const auto n = static_cast<size_t>(a.n);
  std::vector<double> full(n * n);
  for (size_t j = 0; j < n; ++j) {
    for (auto e = static_cast<size_t>(a.starts[j]); e < static_cast<size_t>(a.starts[j + 1]); ++e)
      full[static_cast<size_t>(a.rows[e]) * n + j] = a.values[e];
  }
  return full;
}

// About `per_row` elements a row, of which the diagonal may be small.
SparseMatrix random_sparse(Uniform& uniform, size_t n, size_t per_row) {
  std::vector<double> rows, columns;
  for (size_t i = 0; i < n; ++i) {
    rows.push_back(static_cast<double>(i));
    columns.push_back(static_cast<double>(i));
    for (size_t k = 1; k < per_row; ++k) {
      rows.push_back(static_cast<double>(i));
      columns.push_back(std::floor(uniform(0, static_cast<double>(n))));
    }
  }
  return SparsePattern(SparseFormat::triplets, static_cast<int64_t>(n), rows, columns, rows.size())
      .matrix(random_numbers(uniform, rows.size()));
}

class EveryOrdering : public testing::TestWithParam<Ordering> {};

INSTANTIATE_TEST_SUITE_P(, EveryOrdering,
                         testing::Values(Ordering::amd, Ordering::colamd, Ordering::natural));

TEST_P(EveryOrdering, SolvesWhatTheDenseFactorsSolve) {
  Uniform uniform;
  for (const size_t n : {1, 10, 120}) {
    for (const size_t m : {1, 3}) {
      const SparseMatrix a = random_sparse(uniform, n, 4);
      const auto full = dense(a), b = random_numbers(uniform, n * m);
      const Lu dense_lu(full, n, {.threshold = 1e-300});
      const SparseLu lu(a, {1.0, GetParam()});
      auto x = b, other = b;
      lu.solve(x, m);
      dense_lu.solve(other, m);
      EXPECT_LT(egesp::backward_error(full.data(), b.data(), x.data(), n, m), 1e-15) << n;
      EXPECT_NEAR(egesp::backward_error(lu, b, x, m),
                  egesp::backward_error(full.data(), b.data(), x.data(), n, m), 1e-17);
      auto y = random_numbers(uniform, n), transposed = y;
      dense_lu.solve_transposed(y);
      lu.solve_transposed(transposed);
      for (size_t i = 0; i < n; ++i) EXPECT_NEAR(transposed[i], y[i], 1e-9 * (1 + std::abs(y[i]))) << i;
    }
  }
}

// −u″ on a square of k × k points: with AMD the factors hold O(n log n) numbers, far fewer than a band's 2 k
// n.
TEST(SparseLu, KeepsTheFactorsOfPoissonSparse) {
  const auto a = poisson(60);
  const SparseLu by_amd(a, {}), natural(a, {0.001, Ordering::natural});
  EXPECT_EQ(by_amd.facts().entries, 5 * 3600 - 4 * 60);
  EXPECT_LT(by_amd.facts().factor_entries, 60 * 3600);
  EXPECT_GT(natural.facts().factor_entries, 2 * 50 * 3600);
  EXPECT_EQ(by_amd.facts().blocks, 1);
}

TEST(SparseLu, FindsTheBlocks) {  // upper triangular after a permutation: each unknown is a block
  const auto a = SparsePattern(SparseFormat::triplets, 3, std::vector<double>{2, 0, 0, 1},
                               std::vector<double>{0, 2, 1, 1}, 4)
                     .matrix(std::vector<double>{2, 4, 1, 8});
  const SparseLu lu(a, {});
  EXPECT_EQ(lu.facts().blocks, 3);
  std::vector<double> b{9, 8, 2};
  lu.solve(b, 1);
  EXPECT_THAT(b, testing::ElementsAre(1, 1, 2));
}

// T = 1 takes the largest of the column, a small T the diagonal: on (1e-2 1; 1 1) the first pivots differ.
TEST(SparseLu, ThresholdIsThePreferenceForTheDiagonal) {
  const std::vector<double> rows{0, 1, 0, 1}, columns{0, 0, 1, 1}, values{1e-2, 1, 1, 1};
  const auto a = SparsePattern(SparseFormat::triplets, 2, rows, columns, 4).matrix(values);
  const SparseLu diagonal(a, {1e-3, Ordering::natural}), largest(a, {1, Ordering::natural});
  EXPECT_LT(diagonal.facts().pivot_ratio, 0.02);
  EXPECT_GT(largest.facts().pivot_ratio, 0.5);
}

TEST(SparseLu, TakesOtherValuesInTheSamePlaces) {
  Uniform uniform;
  SparseMatrix a = random_sparse(uniform, 80, 4);
  SparseLu lu(a, {});
  a.values = random_numbers(uniform, a.values.size());
  lu.refactor(a.values);
  auto b = random_numbers(uniform, 80), x = b;
  lu.solve(x, 1);
  EXPECT_LT(backward_error(dense(a).data(), b.data(), x.data(), 80, 1), 1e-12);
}

// The diagonal was the pivot and is lost: with the old order of pivots the growth would be 1e18.
TEST(SparseLu, GivesUpAnOrderOfPivotsThatTurnedBad) {
  const std::vector<double> rows{0, 1, 0, 1}, columns{0, 0, 1, 1}, b{1, 2};
  const SparsePattern pattern(SparseFormat::triplets, 2, rows, columns, 4);
  SparseLu lu(pattern.matrix(std::vector<double>{4, 1, 1, 4}), {});
  for (const double pivot : {1e-18, 0.0}) {
    lu.refactor(pattern.matrix(std::vector<double>{pivot, 1, 1, pivot}).values);
    auto x = b;
    lu.solve(x, 1);
    EXPECT_NEAR(x[0], 2, 1e-15);
    EXPECT_NEAR(x[1], 1, 1e-15);
  }
}

Error refusal_of(const SparseMatrix& a) {
  try {
    SparseLu lu(a, {});
  } catch (const Error& error) {
    return error;
  }
  return Error(Code::internal, "accepted");
}

TEST(SparseLu, SaysWhatIsSingular) {
  const std::vector<double> rows{0, 1, 0, 1}, columns{0, 0, 1, 1};
  const Error dependent = refusal_of(
      SparsePattern(SparseFormat::triplets, 2, rows, columns, 4).matrix(std::vector<double>{1, 2, 2, 4}));
  EXPECT_EQ(dependent.code(), Code::singular);
  EXPECT_THAT(dependent.message(), HasSubstr("no pivot is left in column 1"));
  const Error empty = refusal_of(
      SparsePattern(SparseFormat::triplets, 3, rows, columns, 4).matrix(std::vector<double>{1, 2, 2, 5}));
  EXPECT_EQ(empty.code(), Code::singular);
  EXPECT_THAT(empty.message(), HasSubstr("rank is at most 2 of 3"));
}

TEST(SparseLu, ValuesThatMakeItSingularLeaveNothingToSolveWith) {
  const std::vector<double> rows{0, 1, 0, 1}, columns{0, 0, 1, 1};
  const SparsePattern pattern(SparseFormat::triplets, 2, rows, columns, 4);
  SparseLu lu(pattern.matrix(std::vector<double>{1, 1, 1, 2}), {});
  EXPECT_THROW(lu.refactor({1, 2, 2, 4}), Error);
  std::vector<double> b{1, 1};
  EXPECT_THROW(lu.solve(b, 1), Error);
  lu.refactor({2, 0, 0, 4});
  lu.solve(b, 1);
  EXPECT_THAT(b, testing::ElementsAre(0.5, 0.25));
}

// ‖A‖₁ ‖A⁻¹‖₁ of the second difference (−1, 2, −1) with n unknowns: 4 · (n + 1)² / 8 for odd n.
TEST(SparseLu, ConditionOfTheSecondDifferenceIsKnown) {
  constexpr int n = 99;
  std::vector<double> rows, columns, values;
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - 1); j <= std::min(n - 1, i + 1); ++j) {
      rows.push_back(i), columns.push_back(j), values.push_back(i == j ? 2 : -1);
    }
  }
  const SparseLu lu(SparsePattern(SparseFormat::triplets, n, rows, columns, rows.size()).matrix(values), {});
  EXPECT_NEAR(1 / reciprocal_condition(lu), 4 * 100.0 * 100.0 / 8, 1e-6);
}

}  // namespace
}  // namespace animado::egesp
