// Tests of colisao/bodies.hpp: between the body frame's origin and the centre of mass.
#include "colisao/bodies.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::colisao {
namespace {

const Mat3 kInertia = Vec3(1, 2, 2.5).asDiagonal();

BodyState tumbling() {
  BodyState state;
  state.pose.position_m = {1, 2, 3};
  state.pose.orientation = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
  state.velocity_m_s = {0.3, -0.4, 0.5};
  state.angular_velocity_body_rad_s = {3, -2, 1};
  return state;
}

TEST(Bodies, CenterOfMassOffTheOriginMovesWithTheSpin) {
  BodyState state = tumbling();
  state.pose.orientation = Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()));  // body x is world y
  state.angular_velocity_body_rad_s = {0, 0, 2};
  const Moving m = moving(dynamic_body(2, kInertia, {0.5, 0, 0}), state);
  EXPECT_TRUE(m.center_m.isApprox(Vec3(1, 2.5, 3), 1e-15));
  EXPECT_TRUE(m.velocity_m_s.isApprox(Vec3(0.3 - 1, -0.4, 0.5), 1e-15));  // ω × (0, 0.5, 0) = (−1, 0, 0)
  EXPECT_NEAR(m.inverse_inertia_1_kg_m2(0, 0), 1 / 2.0, 1e-15);
  EXPECT_NEAR(m.inverse_inertia_1_kg_m2(1, 1), 1 / 1.0, 1e-15);
}

TEST(Bodies, SettingVelocitiesIsTheInverse) {
  const Body body = dynamic_body(2, kInertia, {0.5, -0.2, 0.1});
  const BodyState before = tumbling();
  BodyState after = before;
  set_velocities(body, moving(body, before), after);
  EXPECT_LT((after.velocity_m_s - before.velocity_m_s).norm(), 1e-15);
  EXPECT_LT((after.angular_velocity_body_rad_s - before.angular_velocity_body_rad_s).norm(), 2e-15);
}

TEST(Bodies, PushChangesMomentumAndAngularMomentum) {
  const Body body = dynamic_body(2, kInertia);
  Moving m = moving(body, BodyState{});
  m.push({0, 4, 0}, {0.5, 0, 0});
  EXPECT_TRUE(m.velocity_m_s.isApprox(Vec3(0, 2, 0)));
  EXPECT_TRUE(m.spin_rad_s.isApprox(Vec3(0, 0, 2 / 2.5)));
}

TEST(Bodies, ImmovableBodiesMoveAsTheyAreTold) {
  Moving m = moving(immovable_body(Motion::kinematic), tumbling());
  EXPECT_FALSE(m.is_movable());
  const Vec3 velocity = m.velocity_m_s;
  m.push({1, 2, 3}, {4, 5, 6});
  EXPECT_EQ(m.velocity_m_s, velocity);
  EXPECT_EQ(kinetic_energy_J(immovable_body(Motion::kinematic), tumbling()), 0);
}

TEST(Bodies, KineticEnergyIsAboutTheCenterOfMass) {
  const Body body = dynamic_body(2, kInertia, {0.5, 0, 0});
  BodyState state;
  state.angular_velocity_body_rad_s = {0, 0, 2};
  EXPECT_NEAR(kinetic_energy_J(body, state), 0.5 * 2 * 1 + 0.5 * 2.5 * 4, 1e-14);
}

TEST(Bodies, PairRules) {
  Bodies bodies{
      {immovable_body(Motion::fixed), immovable_body(Motion::fixed)}, RestitutionRule::product, 0.01};
  bodies.list[0].restitution = 0.4;
  bodies.list[1].restitution = 0.9;
  bodies.list[0].friction = 0.2;
  bodies.list[1].friction = 0.8;
  EXPECT_DOUBLE_EQ(bodies.surface(0, 1).restitution, 0.36);
  EXPECT_DOUBLE_EQ(bodies.surface(0, 1).friction, 0.4);
  bodies.rule = RestitutionRule::min;
  EXPECT_EQ(bodies.surface(0, 1).restitution, 0.4);
  bodies.rule = RestitutionRule::max;
  EXPECT_EQ(bodies.surface(0, 1).restitution, 0.9);
  bodies.rule = RestitutionRule::mean;
  EXPECT_DOUBLE_EQ(bodies.surface(0, 1).restitution, 0.65);
}

TEST(Bodies, NonsenseIsRefused) {
  EXPECT_THROW(dynamic_body(0, kInertia), Error);
  EXPECT_THROW(dynamic_body(1, -kInertia), Error);
  EXPECT_THROW(dynamic_body(1, Mat3::Constant(NAN)), Error);
}

}  // namespace
}  // namespace animado::colisao
