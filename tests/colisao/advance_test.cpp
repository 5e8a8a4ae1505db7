// Tests of colisao/advance.hpp and island_motion.hpp: the experiments of continuous contact, with closed
// forms.
#include "colisao/advance.hpp"

#include <gtest/gtest.h>

#include "floor_world.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

constexpr double kStep_s = 1.0 / 240;
constexpr double kG = 9.81;

// A cube on an incline: gravity is turned instead of the floor.
FloorWorld incline(double tangent, double friction) {
  FloorWorld world;
  world.gravity_m_s2 = kG * Vec3(tangent, -1, 0).normalized();
  world.set_floor(friction, 0.5);
  world.add_cube(3, 0.5, at({0, 0.5, 0}), friction, 0.5);
  return world;
}

TEST(BoxOnAnIncline, SticksBelowTheAngleOfFriction) {
  FloorWorld world = incline(0.45, 0.5);
  world.run(10, kStep_s, 2);
  EXPECT_LT((world[1].pose.position_m - Vec3(0, 0.5, 0)).norm(), 1e-6);
  EXPECT_LT(world[1].velocity_m_s.norm(), 1e-7);
  EXPECT_LT(world[1].pose.orientation.angularDistance(Quat::Identity()), 1e-6);
  EXPECT_LT(world.last.account.residual_m_s, 1e-12);
}

TEST(BoxOnAnIncline, SlidesAboveIt) {  // x = ½ g (sin θ − μ cos θ) t²
  FloorWorld world = incline(0.8, 0.5);
  const double start = world.energy_J();
  world.run(2, kStep_s, 2);
  const double acceleration = kG * (0.8 - 0.5) / std::hypot(0.8, 1);
  EXPECT_NEAR(world[1].velocity_m_s.x() / 2, acceleration, 1e-6);
  EXPECT_NEAR(world[1].pose.position_m.x(), acceleration * 2, 1e-6);
  EXPECT_NEAR(world[1].pose.position_m.y(), 0.5, 1e-7);
  EXPECT_NEAR(start - world.energy_J(), world.dissipated_J, 1e-9 * world.dissipated_J);
}

TEST(BoxOnAFloor, SlidesToAStop) {  // v² / 2 μ g
  FloorWorld world;
  world.set_floor(0.4, 0.5);
  world.add_cube(3, 0.5, at({0, 0.5, 0}, {2, 0, 0}), 0.4, 0.5);
  world.run(1, kStep_s, 4);
  EXPECT_NEAR(world[1].pose.position_m.x(), 4 / (2 * 0.4 * kG), 1e-5);
  EXPECT_LT(world[1].velocity_m_s.norm(), 1e-9);
}

TEST(Ball, SlidingOneEndsRolling) {  // v = 5/7 v₀, whatever the friction
  FloorWorld world;
  world.set_floor(0.3, 0.5);
  world.add_ball(2, 0.5, at({0, 0.5, 0}, {3, 0, 0}), 0.3, 0.5);
  const double start = world.energy_J();
  world.run(2, kStep_s, 2);
  EXPECT_NEAR(world[1].velocity_m_s.x(), 3 * 5.0 / 7, 1e-9);
  EXPECT_NEAR(world[1].angular_velocity_rad_s().z(), -3 * 5.0 / 7 / 0.5, 1e-9);
  const double slid_s = 2 * 3 / (7 * 0.3 * kG);
  EXPECT_NEAR(world[1].pose.position_m.x(),
              3 * slid_s - 0.15 * kG * slid_s * slid_s + (2 - slid_s) * 3 * 5 / 7.0, 1e-5);
  EXPECT_NEAR(world.dissipated_J, start - world.energy_J(), 1e-9);
  EXPECT_NEAR(world.dissipated_J, 2 * 9 / 7.0,
              1e-3);  // m v₀² / 7, less what the last sliding sub-step cuts short
}

TEST(Ball, RollingOneKeepsRolling) {
  FloorWorld world;
  world.set_floor(0.3, 0.5);
  world.add_ball(2, 0.5, at({0, 0.5, 0}, {3, 0, 0}, {0, 0, -6}), 0.3, 0.5);
  world.run(5, kStep_s, 2);
  EXPECT_NEAR(world[1].velocity_m_s.x(), 3, 1e-10);
  EXPECT_NEAR(world[1].pose.position_m.x(), 15, 1e-9);
  EXPECT_NEAR(world[1].pose.position_m.y(), 0.5, 1e-12);
}

TEST(Ball, RollsDownAnIncline) {  // a = 5/7 g sin θ
  FloorWorld world;
  world.gravity_m_s2 = kG * Vec3(0.3, -1, 0).normalized();
  world.set_floor(0.5, 0.5);
  world.add_ball(2, 0.5, at({0, 0.5, 0}), 0.5, 0.5);
  world.run(2, kStep_s, 2);
  EXPECT_NEAR(world[1].velocity_m_s.x(), 5.0 / 7 * kG * 0.3 / std::hypot(0.3, 1) * 2, 1e-9);
  EXPECT_NEAR(world.dissipated_J, 0, 1e-9);
}

TEST(Advance, BodiesThatTouchNothingKeepTheFreeResult) {
  FloorWorld world;
  world.add_cube(3, 0.5, at({0, 0.5, 0}), 0.5, 0.5);
  world.add_ball(2, 0.5, at({5, 3, 0}, {1, 2, 3}, {4, 5, 6}), 0.5, 0.5);
  world.add_ball(2, 0.5, at({9, 0.5, 0}, {0, 1, 0}), 0.5, 0.5);        // leaves the floor
  world.add_ball(2, 0.5, at({12, 0.5, 0}, {0, 0.0095, 0}), 0.5, 0.5);  // slowly; gravity brings it back
  std::vector<BodyState> states = world.states;
  std::vector<double> free = world.packed(states), accelerations(6 * states.size(), 0.0);
  for (double& x : free) x += 0.1234567;
  const std::vector<double> state = world.packed(states);
  for (size_t i = 1; i < states.size(); ++i) accelerations[states.size() + i] = -kG;
  for (const bool crowded : {false, true}) {
    const AdvanceResult result = advance(world.bodies, world.finder(),
                                         {state.data(), accelerations.data(), free.data(), 0.01, 3, crowded});
    EXPECT_EQ(result.moved, (std::vector<int>{1, 4}));
    for (size_t row = 0; row < kStateRows; ++row) {
      for (size_t i : {0u, 2u, 3u})
        EXPECT_EQ(result.state[row * states.size() + i], free[row * states.size() + i]);
    }
  }
}

TEST(Advance, SameRequestSameBits) {
  FloorWorld once, twice;
  for (FloorWorld* world : {&once, &twice}) {
    world->set_floor(0.4, 0.3);
    BodyState tilted = at({0, 1.2, 0}, {1, -2, 0.3}, {1, 2, 3});
    world->add_cube(3, 0.5, tilted, 0.4, 0.3);
    world->run(1, kStep_s, 4, true);
  }
  EXPECT_EQ(once.last.state, twice.last.state);
}

TEST(Advance, CrowdedBallBounces) {  // height ε² h, to what the sub-step leaves open
  FloorWorld world;
  world.set_floor(0, 1);
  world.add_ball(2, 0.5, at({0, 1.5, 0}), 0, 0.8);
  double highest = 0;
  const double fall_s = std::sqrt(2 / kG);
  while (world.time_s < fall_s * (1 + 2 * 0.8)) {
    world.step(kStep_s, 8, true);
    if (world.time_s > fall_s + 0.05) highest = std::max(highest, world[1].pose.position_m.y() - 0.5);
  }
  EXPECT_NEAR(highest, 0.64, 0.01);
  ASSERT_GE(world.impacts.size(), 1u);
  EXPECT_NEAR(world.impacts[0].time_s, fall_s, kStep_s / 8);
  EXPECT_NEAR(world.impacts[0].answer.approach_m_s, std::sqrt(2 * kG), 0.02);
  EXPECT_NEAR(world.impacts[0].answer.separation_m_s, 0.8 * world.impacts[0].answer.approach_m_s, 1e-12);
}

TEST(Advance, CrowdedBoxesComeToRest) {
  FloorWorld world;
  world.set_floor(0.5, 0.4);
  std::srand(5);
  for (int n = 0; n < 6; ++n) {
    BodyState state = at({3.0 * n, 1.3, 0}, {0, 0, 0}, 3 * Vec3::Random());
    state.pose.orientation = Quat::UnitRandom();
    world.add_cube(3, 0.5, state, 0.5, 0.4);
  }
  const double start = world.energy_J();
  world.run(5, 1.0 / 120, 4, true);
  for (int i = 1; i <= 6; ++i) {
    EXPECT_LT(world[i].velocity_m_s.norm(), 1e-4);
    EXPECT_LT(world[i].angular_velocity_body_rad_s.norm(), 1e-3);
    EXPECT_NEAR(world[i].pose.position_m.y(), 0.5, 1e-4);
  }
  EXPECT_NEAR(start - world.energy_J(), world.dissipated_J, 0.01 * world.dissipated_J);
}

// Four balls in a square and one on top. By the balance of torques a lower ball needs the same friction below
// and above, at most μ ≥ tan(45°/2) = 0.414 for the top ball not to drive them apart.
FloorWorld pyramid_of_balls(double friction) {
  FloorWorld world;
  world.set_floor(friction, 0.2);
  for (double x : {-0.5, 0.5}) {
    for (double z : {-0.5, 0.5}) world.add_ball(2, 0.5, at({x, 0.5, z}), friction, 0.2);
  }
  world.add_ball(1, 0.5, at({0, 0.5 + std::sqrt(0.5), 0}), friction, 0.2);
  return world;
}

TEST(PyramidOfBalls, StandsByFriction) {
  FloorWorld world = pyramid_of_balls(0.45);
  world.run(3, kStep_s, 2, true);
  EXPECT_EQ(world.last.islands, 1);
  EXPECT_LT((world[5].pose.position_m - Vec3(0, 0.5 + std::sqrt(0.5), 0)).norm(), 1e-5);
}

TEST(PyramidOfBalls, FallsWithTooLittle) {
  FloorWorld world = pyramid_of_balls(0.38);
  world.run(3, kStep_s, 2, true);
  EXPECT_LT(world[5].pose.position_m.y(), 0.51);
  for (int i = 1; i <= 5; ++i) EXPECT_GT(world[i].pose.position_m.y(), 0.5 - 1e-3);
}

TEST(Advance, OverlapIsRemovedWithoutSpeed) {
  FloorWorld world;
  world.add_ball(2, 0.5, at({0, 0.48, 0}), 0, 0.5);
  world.run(0.5, kStep_s, 2);
  EXPECT_NEAR(world[1].pose.position_m.y(), 0.5, 1e-6);
  EXPECT_LT(world[1].velocity_m_s.norm(), 1e-9);
  EXPECT_NEAR(world.dissipated_J, -2 * kG * (world[1].pose.position_m.y() - 0.48),
              1e-12);  // the lift is booked
}

TEST(Advance, KinematicFloorLiftsAndReturnsTheBody) {  // the work of the floor is no dissipation
  FloorWorld world;
  world.bodies.list[0].motion = Motion::kinematic;
  world.states[0].velocity_m_s = {0, 0.5, 0};
  world.add_cube(3, 0.5, at({0, 0.5, 0}, {0, 0.5, 0}), 0.5, 0.5);
  world.run(1, kStep_s, 2);
  EXPECT_NEAR(world[1].pose.position_m.y(), 1, 1e-9);
  EXPECT_NEAR(world[1].velocity_m_s.y(), 0.5, 1e-12);
  EXPECT_NEAR(world.dissipated_J, 0, 1e-9);
}

TEST(Advance,
     FasterBeltTakesTheBodyAlong) {  // a conveyor: friction brings the cube to its speed after v / μ g
  FloorWorld world;
  world.bodies.list[0].motion = Motion::kinematic;
  world.bodies.list[0].friction = 0.5;
  world.states[0].velocity_m_s = {1, 0, 0};
  world.add_cube(3, 0.5, at({0, 0.5, 0}), 0.5, 0.5);
  world.run(0.1, kStep_s, 2);
  EXPECT_NEAR(world[1].velocity_m_s.x(), 0.5 * kG * 0.1, 1e-9);
  world.run(1, kStep_s, 2);
  EXPECT_NEAR(world[1].velocity_m_s.x(), 1, 1e-9);
}

TEST(Advance, SpinningTopPrecesses) {  // Ω ≈ m g l / (I₃ ω₃), fast top on its tip, friction holds the tip
  FloorWorld world;
  world.set_floor(1, 0);
  const double mass = 1, arm = 0.1, axial = 2e-3, transverse = 2e-3, spin = 400;
  // The tip is a ball so small that it counts as a point; the centre of mass sits `arm` above it along body
  // y.
  const double tip = 1e-6;
  Body top = dynamic_body(mass, Vec3(transverse, axial, transverse).asDiagonal(), {0, arm, 0});
  top.friction = 1;
  BodyState start;
  start.pose.orientation = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  start.angular_velocity_body_rad_s = {0, spin, 0};
  start.pose.position_m = {0, tip, 0};
  // Steady precession from the start: the spin about the vertical that keeps the tilt.
  const double precession = mass * kG * arm / (axial * spin);
  const Vec3 vertical = precession * Vec3::UnitY();
  start.angular_velocity_body_rad_s += start.pose.orientation.conjugate() * vertical;
  world.add(top, {tip, 0}, start);
  world.bodies.list[1].radius_m = 0.3;
  const double seconds = 1;
  world.run(seconds, 1.0 / 960, 8);
  const Vec3 axis = world[1].pose.orientation * Vec3::UnitY();
  const double turned = std::atan2(-axis.z(), axis.x()) - std::atan2(0, -1);
  EXPECT_NEAR(std::acos(axis.y()), 0.3, 0.01);
  EXPECT_NEAR(std::remainder(turned - precession * seconds, 2 * M_PI), 0, 0.03 * precession);
  EXPECT_LT(world[1].pose.position_m.norm(), 0.01);
}

}  // namespace
}  // namespace animado::colisao
