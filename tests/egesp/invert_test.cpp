// src/egesp/invert.cpp: inverses known in closed form.
#include "egesp/invert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "systems.hpp"

namespace animado::egesp {
namespace {

TEST(Invert, TwoByTwo) {
  std::vector<double> a{4, 7, 2, 6}, inverse(4);
  const Elimination outcome = invert(a, inverse, 2, {});
  EXPECT_TRUE(outcome.solved());
  EXPECT_DOUBLE_EQ(outcome.determinant, 10);
  EXPECT_THAT(inverse, testing::Pointwise(testing::DoubleNear(1e-15), {0.6, -0.7, -0.2, 0.4}));
}

// The inverse of a Hilbert matrix has integer elements (Choi, Tricks or treats with the Hilbert matrix,
// 1983).
TEST(Invert, HilbertFour) {
  for (bool complete : {false, true}) {
    std::vector<double> a = hilbert(4), inverse(16);
    ASSERT_TRUE(invert(a, inverse, 4, {.complete = complete}).solved());
    const double exact[] = {16,  -120,  240,  -140,  -120, 1200, -2700, 1680,
                            240, -2700, 6480, -4200, -140, 1680, -4200, 2800};
    for (size_t e = 0; e < 16; ++e)
      EXPECT_NEAR(inverse[e], exact[e], 1.6e4 * 0x1p-52 * 6480);  // condition number 1.6e4
  }
}

TEST(Invert, APermutationIsInvertedByItsTranspose) {
  std::vector<double> a{0, 1, 0, 0, 0, 1, 1, 0, 0}, inverse(9);
  ASSERT_TRUE(invert(a, inverse, 3, {}).solved());
  EXPECT_THAT(inverse, testing::ElementsAre(0, 0, 1, 1, 0, 0, 0, 1, 0));
}

TEST(Invert, ASingularMatrixIsRefused) {
  std::vector<double> a{1, 2, 2, 4}, inverse(4);
  const Elimination outcome = invert(a, inverse, 2, {});
  EXPECT_FALSE(outcome.solved());
  EXPECT_EQ(outcome.pivots, 1u);
}

}  // namespace
}  // namespace animado::egesp
