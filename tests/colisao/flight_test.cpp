// Tests of colisao/flight.hpp: motion between contacts.
#include "colisao/flight.hpp"

#include <gtest/gtest.h>

namespace animado::colisao {
namespace {

void go(Flight& flight, double substep_s, int count) {
  for (int n = 0; n < count; ++n)
    flight.travel(flight.now(), flight.ahead(flight.now(), substep_s), substep_s);
}

TEST(Flight, ConstantAccelerationIsExact) {
  BodyState start;
  start.velocity_m_s = {1, 2, 0};
  Flight flight(dynamic_body(2, Mat3::Identity()), start, {0, -9.81, 0}, Vec3::Zero());
  go(flight, 0.1, 10);
  EXPECT_LT((flight.state().pose.position_m - Vec3(1, 2 - 9.81 / 2, 0)).norm(), 1e-14);
  EXPECT_LT((flight.state().velocity_m_s - Vec3(1, 2 - 9.81, 0)).norm(), 1e-14);
}

TEST(Flight,
     CenterOfMassOffTheOriginMovesStraight) {  // a free body: its origin has the acceleration −ω×(ω×c)
  const Vec3 c(0.3, 0, 0.1), spin(0, 0, 4);
  const Body body = dynamic_body(2, Mat3::Identity(), c);
  BodyState start;
  start.angular_velocity_body_rad_s = spin;
  Flight flight(body, start, -spin.cross(spin.cross(c)), Vec3::Zero());
  go(flight, 1e-3, 1000);
  const Vec3 velocity = spin.cross(c);
  EXPECT_LT((flight.pose().to_world(c) - (c + velocity)).norm(), 1e-12);
  EXPECT_NEAR(flight.pose().orientation.angularDistance(Quat(Eigen::AngleAxisd(4, Vec3::UnitZ()))), 0, 1e-10);
}

// Relative error of the kinetic energy of a torque-free asymmetric top; its angular momentum does not change.
double energy_error(double substep_s) {
  const Mat3 inertia = Vec3(1, 2, 2.7).asDiagonal();
  const Body body = dynamic_body(2, inertia);
  BodyState start;
  start.angular_velocity_body_rad_s = {0.2, 5, 0.3};
  const Vec3& w = start.angular_velocity_body_rad_s;
  Flight flight(body, start, Vec3::Zero(), -body.inverse_inertia_1_kg_m2 * w.cross(inertia * w));
  go(flight, substep_s, static_cast<int>(std::lround(2 / substep_s)));
  const BodyState& end = flight.state();
  const Vec3 momentum = end.pose.orientation * (inertia * end.angular_velocity_body_rad_s);
  EXPECT_LT((momentum - inertia * w).norm(), 1e-11);
  return std::abs(kinetic_energy_J(body, end) / kinetic_energy_J(body, start) - 1);
}

TEST(Flight, TopKeepsItsAngularMomentumAndNearlyItsEnergy) {
  EXPECT_LT(energy_error(1e-3), 1e-5);
  EXPECT_GT(energy_error(4e-3) / energy_error(2e-3), 3);  // second order or better
}

TEST(Flight, TorqueOfTheStartIsKept) {  // about a fixed axis: θ = ½ α t²
  BodyState start;
  Flight flight(dynamic_body(2, Vec3(1, 2, 3).asDiagonal()), start, Vec3::Zero(), {0, 0, 0.5});
  go(flight, 0.01, 100);
  EXPECT_NEAR(flight.state().angular_velocity_body_rad_s.z(), 0.5, 1e-13);
  EXPECT_NEAR(flight.pose().orientation.angularDistance(Quat(Eigen::AngleAxisd(0.25, Vec3::UnitZ()))), 0,
              1e-7);
}

TEST(Flight, KinematicBodyFollowsItsPath) {
  BodyState start, end;
  start.velocity_m_s = {0, 1, 0};
  end.pose.position_m = {0, 0.1, 0};
  end.velocity_m_s = {0, 1, 0};
  Flight flight(immovable_body(Motion::kinematic), start, end, 0.1);
  EXPECT_NEAR(flight.ahead(flight.now(), 0.05).velocity_m_s.y(), 1, 1e-14);
  go(flight, 0.05, 1);
  EXPECT_NEAR(flight.pose().position_m.y(), 0.05, 1e-15);
  EXPECT_FALSE(flight.now().is_movable());
}

TEST(Flight, FixedBodyStaysToTheLastBit) {
  BodyState start;
  start.pose.position_m = {0.1, 0.2, 0.3};
  Flight flight(immovable_body(Motion::fixed), start, start, 0.1);
  go(flight, 0.05, 2);
  EXPECT_EQ(flight.pose().position_m, start.pose.position_m);
}

TEST(Flight, ShiftMovesThePoseAlone) {
  BodyState start;
  start.velocity_m_s = {1, 2, 3};
  Flight flight(dynamic_body(2, Mat3::Identity(), {0.5, 0, 0}), start, Vec3::Zero(), Vec3::Zero());
  const double before = kinetic_energy_J(dynamic_body(2, Mat3::Identity(), {0.5, 0, 0}), flight.state());
  flight.shift({0, 0.1, 0}, {0, 0, 0.2});
  EXPECT_LT((flight.pose().to_world({0.5, 0, 0}) - Vec3(0.5, 0.1, 0)).norm(), 1e-15);
  EXPECT_NEAR(kinetic_energy_J(dynamic_body(2, Mat3::Identity(), {0.5, 0, 0}), flight.state()), before,
              1e-14);
}

}  // namespace
}  // namespace animado::colisao
