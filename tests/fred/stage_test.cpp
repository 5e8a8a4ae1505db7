// src/fred/stage.cpp: the sum in its stated order, to the bit.
#include "fred/stage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fred/state_sums.hpp"

namespace animado::fred {
namespace {

// Sizes around the register and what is small; from no term to the most.
TEST(Stage, HasTheBitsOfTheSumInOrder) {
  for (size_t size : {1, 2, 3, 7, 15, 16, 17, 18, 19, 20, 513}) {
    for (size_t terms : {0, 1, 2, 3, 4, 5, 8, 11, 16}) {
      std::vector<double> y(size), k(terms * size), coefficients(terms), out(size);
      for (size_t e = 0; e < size; ++e) y[e] = std::sin(static_cast<double>(e));
      for (size_t e = 0; e < k.size(); ++e) k[e] = std::cos(static_cast<double>(e * e));
      for (size_t j = 0; j < terms; ++j) coefficients[j] = j == 1 ? 0 : 1 / static_cast<double>(3 + j);
      combine(y, k, sum_of(coefficients), 0.1, out);
      for (size_t e = 0; e < size; ++e) {
        double sum = 0;
        for (size_t j = 0; j < terms; ++j) {
          if (coefficients[j] != 0)
            sum = j == 0 ? coefficients[j] * k[e] : sum + coefficients[j] * k[j * size + e];
        }
        ASSERT_EQ(out[e], y[e] + 0.1 * sum) << size << " " << terms << " " << e;
      }
    }
  }
}

TEST(Stage, DoesNotReadWhatHasNoWeight) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> y{1, 2}, k{3, 4, nan, nan, 5, 6}, out(2);
  combine(y, k, sum_of(std::vector<double>{1, 0, 2}), 0.5, out);
  EXPECT_EQ(out, (std::vector<double>{1 + 0.5 * 13, 2 + 0.5 * 16}));
}

}  // namespace
}  // namespace animado::fred
