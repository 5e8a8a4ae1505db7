// colisao/path.cpp: the interpolant between two states and its bounds.
#include "colisao/path.hpp"

#include <gtest/gtest.h>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

const BodyState kStart{{{1, 2, 3}, about({1, -1, 2}, 0.4)}, {0.5, -2, 1}, {3, -4, 2}};

double angle_between(const Quat& a, const Quat& b) {
  return 2 * (a.conjugate() * b).vec().norm();
}

TEST(Path, EndsAreTheStates) {
  const Path path(kStart, after(kStart, 0.1), 0.1);
  for (const auto& [time, expected] : {std::pair{0.0, kStart}, std::pair{0.1, after(kStart, 0.1)}}) {
    const BodyState got = path.state(time);
    EXPECT_LT((got.pose.position_m - expected.pose.position_m).norm(), 1e-14);
    EXPECT_LT((got.velocity_m_s - expected.velocity_m_s).norm(), 1e-12);
    EXPECT_LT((got.angular_velocity_body_rad_s - expected.angular_velocity_body_rad_s).norm(), 1e-12);
    EXPECT_LT(angle_between(got.pose.orientation, expected.pose.orientation), 1e-14);
  }
}

TEST(Path, CubicMotionIsExact) {
  // x = t³ − t: from −… at 0 to 6 at 2, with x' = 3t² − 1.
  BodyState from, to;
  from.velocity_m_s = {-1, 0, 0};
  to.pose.position_m = {6, 0, 0};
  to.velocity_m_s = {11, 0, 0};
  const Path path(from, to, 2);
  for (const double t : {0.3, 1.0, 1.7}) {
    EXPECT_NEAR(path.pose(t).position_m.x(), t * t * t - t, 1e-14);
    EXPECT_NEAR(path.state(t).velocity_m_s.x(), 3 * t * t - 1, 1e-13);
  }
  EXPECT_GE(path.speed_m_s(), 11);
  EXPECT_NEAR(path.acceleration_m_s2(), 12, 1e-12);  // 6 t at the end
}

// The interpolant is of the fourth order, but of a steady turn the fourth derivative lies along the
// quaternion itself and is normalised away: what is left is of the fifth.
TEST(Path, SteadyTurnIsFifthOrder) {
  const auto error = [](double h) {
    const Path path(kStart, after(kStart, h), h);
    double most = 0;
    for (int k = 0; k <= 20; ++k) {
      most = std::max(
          most, angle_between(path.pose(k * h / 20).orientation, after(kStart, k * h / 20).pose.orientation));
    }
    return most;
  };
  EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), 5, 0.1);
}

TEST(Path, SignsOfTheQuaternionsDoNotMatter) {
  BodyState end = after(kStart, 0.2), other = end;
  other.pose.orientation.coeffs() *= -1;
  const Path path(kStart, end, 0.2), same(kStart, other, 0.2);
  for (const double t : {0.05, 0.1, 0.2}) {
    EXPECT_LT(angle_between(path.pose(t).orientation, same.pose(t).orientation), 1e-14);
    EXPECT_LT((path.state(t).angular_velocity_body_rad_s - same.state(t).angular_velocity_body_rad_s).norm(),
              1e-12);
  }
}

TEST(Path, NoPointExceedsTheBounds) {
  Random random(61);
  for (int k = 0; k < 50; ++k) {
    const double h = 0.1;
    const BodyState from{random.pose(1), random.vector(9), random.vector(8)};
    BodyState to = after(from, h);
    to.velocity_m_s += random.vector(3);
    to.angular_velocity_body_rad_s += random.vector(3);
    const Path path(from, to, h);
    const double dt = 1e-5;
    for (double t = dt; t < h - dt; t += h / 50) {
      const BodyState before = path.state(t - dt), later = path.state(t + dt), now = path.state(t);
      EXPECT_LE(now.velocity_m_s.norm(), path.speed_m_s() * (1 + 1e-9));
      EXPECT_LE(now.angular_velocity_body_rad_s.norm(), path.angular_speed_rad_s() * (1 + 1e-9));
      EXPECT_LE((later.velocity_m_s - before.velocity_m_s).norm() / (2 * dt),
                path.acceleration_m_s2() * (1 + 1e-6) + 1e-6);
      EXPECT_LE((later.angular_velocity_rad_s() - before.angular_velocity_rad_s()).norm() / (2 * dt),
                path.angular_acceleration_rad_s2() * (1 + 1e-6) + 1e-6);
    }
  }
}

}  // namespace
}  // namespace animado::colisao
