// src/egesp/rank.cpp: ranks known by construction.
#include "egesp/rank.hpp"

#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

size_t of(std::vector<double> a, size_t rows, size_t columns, double threshold = 0) {
  return rank(a, rows, columns, threshold);
}

TEST(Rank, OfSmallMatrices) {
  EXPECT_EQ(of({0, 0, 0, 0}, 2, 2), 0u);
  EXPECT_EQ(of({1, 2, 2, 4}, 2, 2), 1u);
  EXPECT_EQ(of({1, 2, 3, 4, 5, 6, 7, 8, 9}, 3, 3), 2u);
  EXPECT_EQ(of({0, 0, 5, 0, 0, 0}, 2, 3), 1u);  // the only pivot is in the last column
  EXPECT_EQ(of({1, 0, 0, 1, 1, 1}, 3, 2), 2u);
}

// A product of (rows × r) and (r × columns) random matrices has rank r.
TEST(Rank, OfProductsOfThinMatrices) {
  Uniform uniform;
  constexpr size_t rows = 40, columns = 55;
  for (size_t r : {1, 2, 7, 20, 40}) {
    const auto left = random_numbers(uniform, rows * r), right = random_numbers(uniform, r * columns);
    std::vector<double> a(rows * columns);
    for (size_t i = 0; i < rows; ++i) {
      for (size_t j = 0; j < columns; ++j) {
        for (size_t k = 0; k < r; ++k) a[i * columns + j] += left[i * r + k] * right[k * columns + j];
      }
    }
    EXPECT_EQ(of(a, rows, columns), r);
  }
}

TEST(Rank, ThresholdCutsSmallPivots) {
  EXPECT_EQ(of({1, 0, 0, 1e-6}, 2, 2), 2u);
  EXPECT_EQ(of({1, 0, 0, 1e-6}, 2, 2, 1e-5), 1u);
}

}  // namespace
}  // namespace animado::egesp
