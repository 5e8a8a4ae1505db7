// Tests of colisao/anderson.hpp.
#include "colisao/anderson.hpp"

#include <gtest/gtest.h>

namespace animado::colisao {
namespace {

using Vector = Anderson::Vector;

Vector cosine(const Vector& x) {
  return x.array().cos();
}

TEST(Anderson, SolvesALinearIterationInAsManyStepsAsItHasUnknowns) {
  Eigen::Matrix3d m;
  m << 0.9, 0.05, 0, 0.05, 0.8, 0.05, 0, 0.05, 0.9;  // the plain iteration would take hundreds
  const Eigen::Vector3d b(1, 2, 3), solution = (Eigen::Matrix3d::Identity() - m).inverse() * b;
  Anderson anderson(5);
  Vector x = Vector::Zero(3);
  for (int n = 0; n < 5; ++n) x = anderson.next(x, m * x + b);
  EXPECT_LT((x - solution).norm(), 1e-9 * solution.norm());
}

TEST(Anderson, FindsAFixedPointOfACurvedMap) {  // cos x = x at 0.739085133215161
  Anderson anderson(2);
  Vector x = Vector::Constant(1, 0.1);
  for (int n = 0; n < 8; ++n) x = anderson.next(x, cosine(x));
  EXPECT_NEAR(x[0], 0.739085133215161, 1e-12);
}

TEST(Anderson, StaysWhereItIsDone) {
  Anderson anderson(3);
  const Vector x = Vector::Constant(2, 1.5);
  for (int n = 0; n < 4; ++n) EXPECT_EQ(anderson.next(x, x), x);
}

TEST(Anderson, ForgetsWhatItIsTold) {
  Anderson anderson(3);
  const Vector x = Vector::Zero(1), image = Vector::Constant(1, 0.5), next = Vector::Constant(1, 0.75);
  anderson.next(x, image);
  anderson.forget();
  EXPECT_EQ(anderson.next(image, next), next);
}

}  // namespace
}  // namespace animado::colisao
