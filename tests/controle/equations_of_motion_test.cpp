#include "controle/equations_of_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "base/state.hpp"

namespace animado::controle {
namespace {

// One body with its centre of mass off the origin, turned and spinning.
struct Hammer {
  Inertia inertia{2.5, {0.1, 0.4, -0.2}, Vec3(0.3, 0.5, 0.6).asDiagonal()};
  BodyState state;

  Hammer() {
    state.pose.orientation = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    state.velocity_m_s = {1, -2, 0.5};
    state.angular_velocity_body_rad_s = {3, -1, 2};
  }
};

// The rates of a lone body under a force through its centre of mass and a torque about it, world.
std::array<double, kStateRows> rates(const Hammer& hammer, const Vec3& force, const Vec3& torque) {
  const EquationsOfMotion equations(std::span(&hammer.inertia, 1));
  std::array<double, kStateRows> state, out;
  store_body(state.data(), 1, 0, hammer.state);
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> matrix;
  equations.matrices(matrix.data());
  Eigen::Matrix<double, 6, 1> wrench, right_side;
  wrench << force, torque;
  equations.right_sides(state.data(), wrench.data(), right_side.data());
  const Eigen::Matrix<double, 6, 1> accelerations = matrix.partialPivLu().solve(right_side);
  std::ranges::copy(accelerations, out.begin() + kVx);
  equations.complete_rates(state.data(), out.data());
  return out;
}

}  // namespace

// Newton: the centre of mass is accelerated by f/m, wherever the frame's origin is.
TEST(EquationsOfMotion, AccelerateTheCentreOfMassByForceOverMass) {
  const Hammer hammer;
  const Vec3 force(4, -3, 7);
  const auto rate = rates(hammer, force, {0.5, 1, -2});
  const Quat& q = hammer.state.pose.orientation;
  const Vec3 origin(rate[kVx], rate[kVy], rate[kVz]), turn(rate[kWx], rate[kWy], rate[kWz]);
  const Vec3 &w = hammer.state.angular_velocity_body_rad_s, &c = hammer.inertia.center_of_mass_m;
  const Vec3 center = origin + q * (turn.cross(c) + w.cross(w.cross(c)));
  EXPECT_LT((center - force / hammer.inertia.mass_kg).norm(), 1e-13);
}

// Euler, about the centre of mass: τ = I ẇ + w × I w in body axes.
TEST(EquationsOfMotion, TurnByEulersEquations) {
  const Hammer hammer;
  const Vec3 torque(0.5, 1, -2);
  const auto rate = rates(hammer, {4, -3, 7}, torque);
  const Vec3 turn(rate[kWx], rate[kWy], rate[kWz]), &w = hammer.state.angular_velocity_body_rad_s;
  const Mat3& I = hammer.inertia.inertia_kg_m2;
  const Vec3 expected = hammer.state.pose.orientation.conjugate() * torque;
  EXPECT_LT((I * turn + w.cross(I * w) - expected).norm(), 1e-13);
}

TEST(EquationsOfMotion, ChangeTheQuaternionByHalfItsProductWithTheAngularVelocity) {
  const Hammer hammer;
  const auto rate = rates(hammer, Vec3::Zero(), Vec3::Zero());
  const Vec3& w = hammer.state.angular_velocity_body_rad_s;
  const Quat product = hammer.state.pose.orientation * Quat(0, w.x(), w.y(), w.z());
  EXPECT_NEAR(rate[kQw], product.w() / 2, 1e-15);
  EXPECT_NEAR(rate[kQx], product.x() / 2, 1e-15);
  EXPECT_NEAR(rate[kQy], product.y() / 2, 1e-15);
  EXPECT_NEAR(rate[kQz], product.z() / 2, 1e-15);
}

// A quaternion that is a little too long, as a stage's may be, turns nothing else.
TEST(EquationsOfMotion, DoNotDependOnTheLengthOfTheQuaternion) {
  Hammer hammer;
  const auto unit = rates(hammer, {4, -3, 7}, {0.5, 1, -2});
  hammer.state.pose.orientation.coeffs() *= 1.01;
  const auto longer = rates(hammer, {4, -3, 7}, {0.5, 1, -2});
  for (const int row : {kVx, kVy, kVz, kWx, kWy, kWz}) {
    EXPECT_NEAR(unit[static_cast<size_t>(row)], longer[static_cast<size_t>(row)], 1e-13);
  }
}

}  // namespace animado::controle
