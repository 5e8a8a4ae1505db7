// src/base/euler.cpp
#include "base/euler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace animado {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::array<RotationOrder, 6> kOrders = {
    RotationOrder{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

// Three turns of matrices with elements near 1 leave a few roundings in each element; 1e-15 is nine halves of
// an ulp.
constexpr double kFewRoundings = 1e-15;

Mat3 turn(int axis, double angle_rad) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Mat3 m = Mat3::Identity();
  m(u, u) = m(v, v) = std::cos(angle_rad);
  m(v, u) = std::sin(angle_rad);
  m(u, v) = -std::sin(angle_rad);
  return m;
}

double difference(const Quat& a, const Quat& b) {
  return (a.toRotationMatrix() - b.toRotationMatrix()).norm();
}

class EveryOrder : public testing::TestWithParam<RotationOrder> {};

TEST_P(EveryOrder, IsTheProductOfTurnsAboutFixedAxes) {
  const RotationOrder order = GetParam();
  const Vec3 angles_rad(0.3, -0.7, 2.1);
  const Mat3 expected = turn(order[2], angles_rad[order[2]]) * turn(order[1], angles_rad[order[1]]) *
                        turn(order[0], angles_rad[order[0]]);
  EXPECT_LT((orientation_of(angles_rad, order).toRotationMatrix() - expected).norm(), kFewRoundings);
}

TEST_P(EveryOrder, GivesTheAnglesBack) {
  const RotationOrder order = GetParam();
  for (const double first : {-3.0, -0.5, 0.0, 1.2, 3.1}) {
    for (const double second : {-1.5, -0.2, 0.0, 0.9, 1.55}) {
      for (const double third : {-2.9, 0.0, 0.4, 3.0}) {
        Vec3 angles_rad;
        angles_rad[order[0]] = first, angles_rad[order[1]] = second, angles_rad[order[2]] = third;
        // cos(1.55) = 0.02 magnifies the roundings of the outer angles by 50.
        EXPECT_LT((angles_of(orientation_of(angles_rad, order), order) - angles_rad).norm(),
                  50 * kFewRoundings);
      }
    }
  }
}

TEST_P(EveryOrder, KeepsTheRotationInGimbalLock) {
  const RotationOrder order = GetParam();
  for (const double lock : {-kPi / 2, kPi / 2}) {
    Vec3 angles_rad;
    angles_rad[order[0]] = 0.8, angles_rad[order[1]] = lock, angles_rad[order[2]] = -0.3;
    const Quat orientation = orientation_of(angles_rad, order);
    const Vec3 found = angles_of(orientation, order);
    EXPECT_NEAR(found[order[1]], lock, 1e-15);
    EXPECT_LT(difference(orientation_of(found, order), orientation), 2 * kFewRoundings);
  }
}

// Where atan2 of the usual elements would keep half the digits or none.
TEST_P(EveryOrder, KeepsTheRotationNextToTheLock) {
  const RotationOrder order = GetParam();
  for (const double distance : {1e-4, 1e-8, 1e-12, 1e-15, 3e-16}) {
    Vec3 angles_rad;
    angles_rad[order[0]] = 0.8, angles_rad[order[1]] = kPi / 2 - distance, angles_rad[order[2]] = -0.3;
    const Quat orientation = orientation_of(angles_rad, order);
    EXPECT_LT(difference(orientation_of(angles_of(orientation, order), order), orientation),
              2 * kFewRoundings)
        << distance;
  }
}

TEST_P(EveryOrder, TheMiddleAngleStaysWithinARightAngle) {
  const RotationOrder order = GetParam();
  Vec3 angles_rad = Vec3::Zero();
  angles_rad[order[1]] = 2.0;
  const Vec3 found = angles_of(orientation_of(angles_rad, order), order);
  EXPECT_NEAR(found[order[1]], kPi - 2.0, kFewRoundings);
}

TEST_P(EveryOrder, AQuaternionAndItsOppositeAreOneRotation) {
  const Quat q = orientation_of({0.3, -0.7, 2.1}, GetParam());
  EXPECT_EQ(angles_of(q, GetParam()), angles_of(Quat(-q.coeffs()), GetParam()));
}

TEST_P(EveryOrder, NothingTurnedIsPlainZero) {
  const Vec3 angles_rad = angles_of(Quat::Identity(), GetParam());
  for (const double angle : angles_rad) {
    EXPECT_EQ(angle, 0);
    EXPECT_FALSE(std::signbit(angle));
  }
}

INSTANTIATE_TEST_SUITE_P(Euler, EveryOrder, testing::ValuesIn(kOrders), [](const auto& order_info) {
  std::string name;
  for (const int axis : order_info.param) name += "xyz"[axis];
  return name;
});

// A quarter about x, then a quarter about y: the body's z first goes to −y, where the turn about y leaves it.
TEST(Euler, XThenYOnFingers) {
  const Quat q = orientation_of({kPi / 2, kPi / 2, 0}, {0, 1, 2});
  EXPECT_LT((q * Vec3::UnitZ() - Vec3(0, -1, 0)).norm(), kFewRoundings);
  EXPECT_LT((q * Vec3::UnitX() - Vec3(0, 0, -1)).norm(), kFewRoundings);
}

}  // namespace
}  // namespace animado
