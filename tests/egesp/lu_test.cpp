// src/egesp/lu.cpp: factors that are used again.
#include "egesp/lu.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

std::vector<double> transposed(const std::vector<double>& a, size_t n) {
  std::vector<double> t(n * n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) t[j * n + i] = a[i * n + j];
  }
  return t;
}

class LuOfEverySize : public testing::TestWithParam<std::tuple<size_t, bool>> {};

INSTANTIATE_TEST_SUITE_P(, LuOfEverySize,
                         testing::Combine(testing::Values(1, 2, 17, 48, 49, 150), testing::Bool()));

TEST_P(LuOfEverySize, SolvesWithTheMatrixAndItsTransposed) {
  const auto [n, complete] = GetParam();
  Uniform uniform;
  const auto a = random_numbers(uniform, n * n), b = random_numbers(uniform, n);
  const Lu lu(a, n, {.complete = complete});
  ASSERT_TRUE(lu.factored());
  auto x = b;
  lu.solve(x, 1);
  EXPECT_LT(backward_error(a.data(), b.data(), x.data(), n, 1), 0x1p-50);
  x = b;
  lu.solve_transposed(x);
  const auto at = transposed(a, n);
  EXPECT_LT(backward_error(at.data(), b.data(), x.data(), n, 1), 0x1p-50);
}

TEST(Lu, KnowsItsDeterminantAndItsLargestFactor) {
  const Lu lu({1, 2, 4, 4}, 2, {});  // rows exchanged: U = (4 4; 0 1)
  EXPECT_EQ(lu.determinant(), -4);
  EXPECT_EQ(lu.largest_factor(), 4);
}

TEST(Lu, ARefusedPivotIsNamed) {
  const Lu lu({1, 2, 2, 4}, 2, {});
  EXPECT_FALSE(lu.factored());
  EXPECT_EQ(lu.pivots(), 1u);
  EXPECT_EQ(lu.determinant(), 0);
}

}  // namespace
}  // namespace animado::egesp
