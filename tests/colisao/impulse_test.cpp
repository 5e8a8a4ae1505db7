// Tests of colisao/impulse.hpp: impacts at one point with known answers.
#include "colisao/impulse.hpp"

#include <gtest/gtest.h>

#include <random>

#include "response_fixtures.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

struct After {
  Moving a, b;
  PointImpulse answer;
  Vec3 u_before, u;
};

After answered(Moving a, Moving b, const Contact& c, double restitution, double friction,
               double threshold = 0.01) {
  After after{a, b, {}, relative_velocity(a, b, c.point_m), {}};
  const double rebound = rebound_m_s(after.u_before.dot(c.normal), restitution, threshold);
  after.answer = point_impulse(a, b, c, friction, rebound);
  after.a.push(after.answer.impulse_N_s, c.point_m);
  after.b.push(-after.answer.impulse_N_s, c.point_m);
  after.u = relative_velocity(after.a, after.b, c.point_m);
  return after;
}

TEST(Impulse, CentralImpactOfTwoBalls) {  // the scene "two" of the benchmarks: masses 2 and 1.7, ε = 0.5
  const After after = answered(ball(2, 1, {-1, 0, 0}, {1, 0, 0}), ball(1.7, 1, {1, 0, 0}, {-1, 0, 0}),
                               contact(0, 1, {0, 0, 0}, -Vec3::UnitX()), 0.5, 0);
  EXPECT_NEAR(after.a.velocity_m_s.x(), -0.378378378378378, 1e-14);
  EXPECT_NEAR(after.b.velocity_m_s.x(), 0.621621621621622, 1e-14);
}

TEST(Impulse, SlowApproachDoesNotBounce) {
  const After after = answered(ball(2, 1, {0, 1, 0}, {0, -0.009, 0}), immovable(),
                               contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0.9, 0);
  EXPECT_NEAR(after.u.y(), 0, 1e-17);
  EXPECT_EQ(rebound_m_s(-0.011, 0.5, 0.01), 0.0055);
}

TEST(Impulse, SpinningBallGripsTheFloor) {  // sticking: v + ω×r = 0 at the point; L about it is kept
  const After after = answered(ball(2, 0.5, {0, 0.5, 0}, {0, -3, 0}, {0, 0, -10}), immovable(),
                               contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0.8, 1.0);
  EXPECT_EQ(after.answer.friction, Friction::sticks);
  EXPECT_NEAR(after.u.x(), 0, 1e-15);
  EXPECT_NEAR(after.u.y(), 2.4, 1e-14);
  // v_x = (2/7) r ω for a solid ball
  EXPECT_NEAR(after.a.velocity_m_s.x(), 2.0 / 7 * 0.5 * 10, 1e-14);
}

TEST(Impulse, SlidingBallGetsMuTimesTheNormalImpulse) {
  const After after = answered(ball(2, 0.5, {0, 0.5, 0}, {4, -3, 3}), immovable(),
                               contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0.5, 0.1);
  EXPECT_EQ(after.answer.friction, Friction::slides);
  const double normal = 2 * 3 * 1.5;
  EXPECT_TRUE(after.answer.impulse_N_s.isApprox(Vec3(-0.1 * 0.8, 1, -0.1 * 0.6) * normal, 1e-14));
}

TEST(Impulse, OffCenterHitOnABlockSpinsIt) {  // frictionless: K = 1/m + r²/I
  const After after = answered(block(3, {1, 0.5, 0.5}, {0, 0, 0}, {0, -2, 0}), immovable(),
                               contact(0, 1, {0.8, -0.5, 0}, Vec3::UnitY()), 0.5, 0);
  const double inertia = 3.0 / 3 * (1 + 0.25);
  const double normal = 3 / (1 / 3.0 + 0.64 / inertia);
  EXPECT_NEAR(after.answer.impulse_N_s.y(), normal, 1e-13);
  EXPECT_NEAR(after.a.spin_rad_s.z(), 0.8 * normal / inertia, 1e-13);
}

// Whatever meets: ε is kept, friction stays in the cone, momentum stays, energy does not grow.
TEST(Impulse, LawsHoldForRandomImpacts) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> r(-1, 1);
  const auto vector = [&] { return Vec3(r(random), r(random), r(random)); };
  int seen[3] = {};
  for (int n = 0; n < 20000; ++n) {
    Moving a = block(1.5 + r(random), {0.05 + std::abs(r(random)), 1, 0.3}, vector(), vector(), 3 * vector());
    Moving b = n % 3 == 0 ? immovable(vector())
                          : block(1.5 + r(random), {1, 0.1, 0.3}, vector(), vector(), 3 * vector());
    Contact c = contact(0, 1, vector(), vector().normalized());
    if (relative_velocity(a, b, c.point_m).dot(c.normal) > 0) c.normal = -c.normal;
    const double epsilon = std::abs(r(random)), mu = 1.5 * std::abs(r(random));
    const After after = answered(a, b, c, epsilon, mu, 0);
    ++seen[static_cast<int>(after.answer.friction)];
    const Vec3& P = after.answer.impulse_N_s;
    const double normal = P.dot(c.normal), scale = after.u_before.norm();
    ASSERT_GE(normal, 0);
    ASSERT_LE((P - normal * c.normal).norm(), mu * normal * (1 + 1e-12) + 1e-14);
    ASSERT_NEAR(after.u.dot(c.normal), -epsilon * after.u_before.dot(c.normal),
                1e-13 * (1 + scale + P.norm()));
    const double before = kinetic_energy(a) + kinetic_energy(b);
    const double work = P.dot(after.u_before + after.u) / 2;
    ASSERT_LE(work, 1e-13 * (1 + before));
    if (b.is_movable()) {
      ASSERT_NEAR(kinetic_energy(after.a) + kinetic_energy(after.b) - before, work, 1e-12 * (1 + before));
      ASSERT_LT((momentum(a) + momentum(b) - momentum(after.a) - momentum(after.b)).norm(),
                1e-13 * (1 + P.norm()));
    }
  }
  for (int count : seen) EXPECT_GT(count, 100);  // every kind of friction was met
}

TEST(Impulse, FrictionFreeOfCouplingFollowsTheRuleExactly) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> r(-1, 1);
  for (int n = 0; n < 1000; ++n) {  // balls: K has no coupling, so the rule never gains energy
    const Vec3 velocity(r(random), -std::abs(r(random)) - 0.02, r(random));
    const After after = answered(ball(2, 0.5, {0, 0.5, 0}, velocity), immovable(),
                                 contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0.5, 0.2);
    ASSERT_NE(after.answer.friction, Friction::given);
  }
}

}  // namespace
}  // namespace animado::colisao
