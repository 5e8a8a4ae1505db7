// Tests of colisao/springs.hpp: the paper's equation (2) along the normal.
#include "colisao/springs.hpp"

#include <gtest/gtest.h>

#include "floor_world.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

struct OnSpring : ::testing::Test {
  FloorWorld world;
  SpringForces forces(const BodyState& ball, double friction = 0.5) {
    world.set_floor(friction, 0);
    world.add_ball(2, 0.5, ball, friction, 0);
    std::vector<Contact> contacts;
    world.manifold(0, world[0].pose, 1, world[1].pose, 1, contacts);
    return spring_forces(world.bodies, world.states, contacts, 1000, 10);
  }
  // Row of the wrench of the ball: 0–2 force, 3–5 torque.
  static double ball(const SpringForces& f, size_t row) { return f.wrenches[2 * row + 1]; }
};

TEST_F(OnSpring, PushesInProportionToOverlapAndApproach) {
  const SpringForces f = forces(at({0, 0.49, 0}, {0, -0.3, 0}));
  EXPECT_NEAR(ball(f, 1), 1000 * 0.01 + 10 * 0.3, 1e-10);
  EXPECT_NEAR(f.wrenches[2], -ball(f, 1), 1e-12);  // on the floor
  EXPECT_NEAR(f.stored_J, 0.5 * 1000 * 1e-4, 1e-12);
}

TEST_F(OnSpring, NeverPulls) {
  EXPECT_EQ(ball(forces(at({0, 0.49, 0}, {0, 3, 0})), 1), 0);
}

TEST_F(OnSpring, GapHasNoForce) {
  const SpringForces f = forces(at({0, 0.51, 0}, {0, -3, 0}));
  for (double x : f.wrenches) EXPECT_EQ(x, 0);
  EXPECT_EQ(f.stored_J, 0);
}

TEST_F(OnSpring, FrictionIsAtMostMuTimesTheNormalForceAndTurnsTheBall) {
  const SpringForces f = forces(at({0, 0.49, 0}, {4, 0, 0}));
  EXPECT_LE(-ball(f, 0), 0.5 * 10);
  EXPECT_NEAR(ball(f, 0), -0.5 * 10, 1e-4);
  EXPECT_NEAR(ball(f, 5), ball(f, 0) * 0.495, 1e-10);  // the point lies midway between the surfaces
}

TEST_F(OnSpring, FrictionVanishesWithTheSliding) {
  EXPECT_NEAR(ball(forces(at({0, 0.49, 0}, {1e-6, 0, 0})), 0), -0.5 * 10 * 1e-6 / 0.01, 1e-9);
}

}  // namespace
}  // namespace animado::colisao
