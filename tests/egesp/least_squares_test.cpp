// src/egesp/least_squares.cpp: fits known in closed form, ranks and null spaces known by construction.
#include "egesp/least_squares.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

// A product of (rows × rank) and (rank × columns) random matrices.
std::vector<double> of_rank(Uniform& uniform, size_t rank, size_t rows, size_t columns) {
  const auto left = random_numbers(uniform, rows * rank), right = random_numbers(uniform, rank * columns);
  std::vector<double> a(rows * columns);
  for (size_t i = 0; i < rows; ++i) {
    for (size_t j = 0; j < columns; ++j) {
      for (size_t k = 0; k < rank; ++k) a[i * columns + j] += left[i * rank + k] * right[k * columns + j];
    }
  }
  return a;
}

// max |Aᵀ (b − A x)|: zero at the minimum, whatever the rank.
double gradient(const LeastSquaresProblem& p, const std::vector<double>& x) {
  double largest = 0;
  for (size_t c = 0; c < p.m; ++c) {
    std::vector<long double> g(p.columns);
    for (size_t i = 0; i < p.rows; ++i) {
      long double r = p.b[i * p.m + c];
      for (size_t j = 0; j < p.columns; ++j)
        r -= static_cast<long double>(p.a[i * p.columns + j]) * x[j * p.m + c];
      for (size_t j = 0; j < p.columns; ++j) g[j] += p.a[i * p.columns + j] * r;
    }
    for (long double v : g) largest = std::max(largest, static_cast<double>(std::abs(v)));
  }
  return largest;
}

double norm(const std::vector<double>& x) {
  double squares = 0;
  for (double v : x) squares += v * v;
  return std::sqrt(squares);
}

TEST(LeastSquares, FitsALine) {
  // y = 1, 2, 2, 4 at t = 0, 1, 2, 3: by the normal equations y = 0.9 + 0.9 t, with residuals 0.1, 0.2, −0.7,
  // 0.4.
  const std::vector<double> a{1, 0, 1, 1, 1, 2, 1, 3}, b{1, 2, 2, 4};
  const auto found = least_squares({a, b, 4, 2, 1});
  EXPECT_EQ(found.rank, 2u);
  EXPECT_THAT(found.x, Pointwise(DoubleNear(1e-14), {0.9, 0.9}));
  EXPECT_NEAR(found.residual_norms.at(0), std::sqrt(0.7), 1e-14);
}

TEST(LeastSquares, SolvesASquareSystem) {
  Uniform uniform;
  constexpr size_t n = 60;
  const auto a = random_numbers(uniform, n * n), b = random_numbers(uniform, n * 2);
  const auto found = least_squares({a, b, n, n, 2});
  EXPECT_EQ(found.rank, n);
  EXPECT_LT(backward_error(a.data(), b.data(), found.x.data(), n, 2), 1e-15);
  EXPECT_LT(found.residual_norms.at(1), 1e-12);
}

TEST(LeastSquares, OfOneEquationTakesTheShortestOnRequest) {
  const std::vector<double> a{3, 4}, b{50};
  const auto shortest = least_squares({a, b, 1, 2, 1, 0, true});
  EXPECT_THAT(shortest.x, Pointwise(DoubleNear(1e-13), {6.0, 8.0}));
  const auto basic = least_squares({a, b, 1, 2, 1});
  EXPECT_THAT(basic.x, ElementsAre(0, 12.5));
  EXPECT_EQ(basic.rank, 1u);
}

TEST(LeastSquares, EveryShapeAndRankIsAtTheMinimum) {
  Uniform uniform;
  for (const auto& [rows, columns] :
       {std::pair<size_t, size_t>{30, 30}, {70, 20}, {20, 70}, {1, 9}, {9, 1}}) {
    for (const size_t rank : {size_t{1}, std::min(rows, columns) / 2 + 1, std::min(rows, columns)}) {
      if (rank > std::min(rows, columns)) continue;
      const auto a = of_rank(uniform, rank, rows, columns), b = random_numbers(uniform, rows * 2);
      for (const bool minimum_norm : {false, true}) {
        const LeastSquaresProblem problem{a, b, rows, columns, 2, 1e-12, minimum_norm};
        const auto found = least_squares(problem);
        EXPECT_EQ(found.rank, rank) << rows << "x" << columns;
        EXPECT_LT(gradient(problem, found.x), 1e-11) << rows << "x" << columns << " of rank " << rank;
      }
    }
  }
}

// What is shortest has no part in the null space: it is no longer than the basic solution, and adding the
// difference of the two, which lies in the null space, at any length makes it longer.
TEST(LeastSquares, TheShortestIsOrthogonalToTheNullSpace) {
  Uniform uniform;
  const auto a = of_rank(uniform, 7, 25, 15), b = random_numbers(uniform, 25);
  const auto basic = least_squares({a, b, 25, 15, 1, 1e-12, false}).x;
  const auto shortest = least_squares({a, b, 25, 15, 1, 1e-12, true}).x;
  EXPECT_EQ(std::ranges::count_if(basic, [](double v) { return v != 0; }), 7);
  double product = 0;
  for (size_t j = 0; j < 15; ++j) product += shortest[j] * (basic[j] - shortest[j]);
  EXPECT_LT(norm(shortest), norm(basic));
  EXPECT_NEAR(product, 0, 1e-11 * norm(basic) * norm(basic));
}

TEST(LeastSquares, OfZeroIsZero) {
  const std::vector<double> a(6), b{3, 4};
  const auto found = least_squares({a, b, 2, 3, 1, 0, true});
  EXPECT_EQ(found.rank, 0u);
  EXPECT_THAT(found.x, ElementsAre(0, 0, 0));
  EXPECT_EQ(found.residual_norms.at(0), 5);
}

TEST(LeastSquares, TheThresholdDecidesTheRank) {
  const std::vector<double> a{1, 0, 0, 1e-6}, b{1, 1};
  EXPECT_EQ(least_squares({a, b, 2, 2, 1, 1e-7}).rank, 2u);
  EXPECT_EQ(least_squares({a, b, 2, 2, 1, 1e-5}).rank, 1u);
}

TEST(LeastSquares, NumbersWhoseSquaresLeaveTheDoublesAreFine) {
  for (const double scale : {1e-200, 1e200}) {
    const std::vector<double> a{3 * scale, 0, 4 * scale, 0, 0, scale}, b{3, 4, 1};
    const auto found = least_squares({a, b, 3, 2, 1});
    EXPECT_EQ(found.rank, 2u);
    EXPECT_THAT(found.x, Pointwise(DoubleNear(1e-14 / scale), {1 / scale, 1 / scale}));
  }
}

}  // namespace
}  // namespace animado::egesp
