// Tests of colisao/simultaneous.hpp: impacts at one time.
#include "colisao/simultaneous.hpp"

#include <gtest/gtest.h>

#include "response_fixtures.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

constexpr double kThreshold = 0.01;

// Balls of radius 1 and mass 1 that touch in a row along x.
std::vector<Moving> row_of_balls(const std::vector<double>& velocities) {
  std::vector<Moving> balls;
  for (size_t n = 0; n < velocities.size(); ++n) {
    balls.push_back(ball(1, 1, {2.0 * static_cast<double>(n), 0, 0}, {velocities[n], 0, 0}));
  }
  return balls;
}
std::vector<Meet> row_of_contacts(int balls, Surface surface) {
  std::vector<Meet> meets;
  for (int n = 0; n + 1 < balls; ++n)
    meets.push_back({contact(n, n + 1, {2.0 * n + 1, 0, 0}, -Vec3::UnitX()), surface, 0});
  return meets;
}

struct Totals {
  Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
  double energy = 0;
};
Totals totals(const std::vector<Moving>& bodies) {
  Totals sum;
  for (const Moving& m : bodies) {
    sum.momentum += momentum(m);
    sum.angular += angular_momentum(m);
    sum.energy += kinetic_energy(m);
  }
  return sum;
}

TEST(Simultaneous, CradleHandsOneBallOn) {
  auto balls = row_of_balls({1, 0, 0, 0, 0});
  const auto result = respond_together(balls, row_of_contacts(5, {1, 0}), kThreshold);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.rounds, 4);
  EXPECT_EQ(result.impacts.size(), 4u);
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(balls[n].velocity_m_s.x(), 0, 1e-12);
  EXPECT_NEAR(balls[4].velocity_m_s.x(), 1, 1e-12);
}

TEST(Simultaneous, CradleHandsTwoBallsOn) {
  auto balls = row_of_balls({1, 1, 0, 0, 0});
  respond_together(balls, row_of_contacts(5, {1, 0}), kThreshold);
  for (int n = 0; n < 3; ++n) EXPECT_NEAR(balls[n].velocity_m_s.x(), 0, 1e-12);
  for (int n = 3; n < 5; ++n) EXPECT_NEAR(balls[n].velocity_m_s.x(), 1, 1e-12);
}

TEST(Simultaneous, CradleFromBothSides) {
  auto balls = row_of_balls({1, 0, 0, 0, -1});
  respond_together(balls, row_of_contacts(5, {1, 0}), kThreshold);
  EXPECT_NEAR(balls[0].velocity_m_s.x(), -1, 1e-12);
  EXPECT_NEAR(balls[4].velocity_m_s.x(), 1, 1e-12);
  for (int n = 1; n < 4; ++n) EXPECT_NEAR(balls[n].velocity_m_s.x(), 0, 1e-12);
}

class FlatBox : public ::testing::TestWithParam<double> {};

TEST_P(FlatBox, DoesNotSpin) {
  const double friction = GetParam();
  std::vector<Moving> bodies = {block(3, {0.5, 0.5, 0.5}, {0, 0.5, 0}, {0, -2, 0}), immovable()};
  std::vector<Meet> meets;
  for (double x : {-0.5, 0.5}) {
    for (double z : {-0.5, 0.5})
      meets.push_back({contact(0, 1, {x, 0, z}, Vec3::UnitY()), {0.5, friction}, 0});
  }
  const auto result = respond_together(bodies, meets, kThreshold);
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(bodies[0].velocity_m_s.y(), 1, 1e-13);
  EXPECT_LT(bodies[0].spin_rad_s.norm(), 1e-13);
  EXPECT_NEAR(result.dissipated_impact_J, 0.5 * 3 * (4 - 1), 1e-12);
  EXPECT_NEAR(result.dissipated_friction_J, 0, 1e-12);
}
INSTANTIATE_TEST_SUITE_P(Simultaneous, FlatBox, ::testing::Values(0.0, 0.5));

TEST(Simultaneous, RestingBallUnderAFallingOneEndsWithoutApproach) {
  std::vector<Moving> bodies = {ball(1, 1, {0, 1, 0}, {0, 0, 0}), ball(1, 1, {0, 3, 0}, {0, -4, 0}),
                                immovable()};
  const std::vector<Meet> meets = {{contact(0, 1, {0, 2, 0}, -Vec3::UnitY()), {0.6, 0}, 0},
                                   {contact(0, 2, {0, 0, 0}, Vec3::UnitY()), {0.6, 0}, 0}};
  const auto result = respond_together(bodies, meets, kThreshold);
  EXPECT_TRUE(result.converged);
  EXPECT_GE(bodies[0].velocity_m_s.y(), -1e-12);
  EXPECT_GE(bodies[1].velocity_m_s.y(), bodies[0].velocity_m_s.y() - 1e-12);
  EXPECT_NEAR(8 - result.dissipated_impact_J, totals(bodies).energy, 1e-12);
}

TEST(Simultaneous, BreakOfATriangleIsSymmetric) {  // a ball between two that touch: both are answered at once
  const double c = std::sqrt(3.0);
  std::vector<Moving> bodies = {ball(1, 1, {0, 0, 0}, {1, 0, 0}), ball(1, 1, {c, 1, 0}, {0, 0, 0}),
                                ball(1, 1, {c, -1, 0}, {0, 0, 0})};
  const std::vector<Meet> meets = {{contact(0, 1, {c / 2, 0.5, 0}, Vec3(-c / 2, -0.5, 0)), {1, 0}, 0},
                                   {contact(0, 2, {c / 2, -0.5, 0}, Vec3(-c / 2, 0.5, 0)), {1, 0}, 0},
                                   {contact(1, 2, {c, 0, 0}, Vec3(0, 1, 0)), {1, 0}, 0}};
  respond_together(bodies, meets, kThreshold);
  EXPECT_NEAR(bodies[0].velocity_m_s.x(), -0.2, 1e-12);  // known answer for the symmetric break
  EXPECT_NEAR(bodies[1].velocity_m_s.x(), 0.6, 1e-12);
  EXPECT_NEAR(bodies[1].velocity_m_s.y(), 0.2 * c, 1e-12);
  EXPECT_NEAR(bodies[2].velocity_m_s.y(), -bodies[1].velocity_m_s.y(), 1e-12);
}

// A heap of random contacts: the books close and nothing approaches in the end.
TEST(Simultaneous, BooksCloseWithFrictionAndMixedRestitution) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::srand(seed);
    std::vector<Moving> bodies;
    for (int n = 0; n < 5; ++n)
      bodies.push_back(block(1 + n, {0.5, 0.4, 0.3}, Vec3::Random() * 2, Vec3::Random(), 2 * Vec3::Random()));
    std::vector<Meet> meets;
    for (int a = 0; a < 5; ++a) {
      for (int b = a + 1; b < 5; ++b) {
        const Vec3 point = (bodies[a].center_m + bodies[b].center_m) / 2;
        const Vec3 normal = (bodies[a].center_m - bodies[b].center_m + 0.3 * Vec3::Random()).normalized();
        meets.push_back(
            {contact(a, b, point + 0.1 * Vec3::Random(), normal), {0.1 * (a + b), 0.2 * (b - a)}, 0});
      }
    }
    const Totals before = totals(bodies);
    const auto result = respond_together(bodies, meets, kThreshold);
    const Totals after = totals(bodies);
    EXPECT_TRUE(result.converged) << seed << " residual " << result.residual_m_s;
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-13 * (1 + before.momentum.norm())) << seed;
    EXPECT_LT((after.angular - before.angular).norm(), 1e-12 * (1 + before.angular.norm())) << seed;
    EXPECT_LE(after.energy, before.energy * (1 + 1e-13)) << seed;
    EXPECT_NEAR(before.energy - after.energy, result.dissipated_impact_J + result.dissipated_friction_J,
                1e-12 * before.energy);
    for (const Meet& m : meets) {
      const Vec3 u = bodies[static_cast<size_t>(m.contact.a)].velocity_at(m.contact.point_m) -
                     bodies[static_cast<size_t>(m.contact.b)].velocity_at(m.contact.point_m);
      EXPECT_GE(u.dot(m.contact.normal), -1e-10) << seed;
    }
  }
}

TEST(Simultaneous, SlowContactsAreLeftToContinuousContact) {
  auto balls = row_of_balls({0.009, 0, 0});
  const auto result = respond_together(balls, row_of_contacts(3, {1, 0}), kThreshold);
  EXPECT_TRUE(result.impacts.empty());
  EXPECT_EQ(balls[0].velocity_m_s.x(), 0.009);
}

TEST(Simultaneous, ImpactIsRecordedWithItsSpeeds) {
  auto balls = row_of_balls({3, 0});
  const auto result = respond_together(balls, row_of_contacts(2, {0.5, 0}), kThreshold);
  ASSERT_EQ(result.impacts.size(), 1u);
  EXPECT_NEAR(result.impacts[0].approach_m_s, 3, 1e-14);
  EXPECT_NEAR(result.impacts[0].separation_m_s, 1.5, 1e-14);
  EXPECT_NEAR(result.impacts[0].impulse_N_s.x(), -2.25, 1e-14);
}

}  // namespace
}  // namespace animado::colisao
