// Coulomb's friction: a box on an incline that sticks and one that slides, a ball that slides until it rolls.
#include <cmath>
#include <numbers>

#include "laboratory.hpp"

namespace animado::experiments {
namespace {

constexpr double kGravity_m_s2 = 9.81;

// An incline of the given angle through the origin, falling towards +x, and a box of edge 1 that lies on it.
std::string incline(double degrees, double friction, double end_s) {
  return fmt::format(R"(
world
  gravity (0, -9.81, 0)
object incline
  shape plane(normal = (sin({0} deg), cos({0} deg), 0), offset = 0)
  motion static
  friction {1}
object crate
  shape cube(edge = 1)
  mass 3
  restitution 0
  friction {1}
  position (0.5*sin({0} deg), 0.5*cos({0} deg), 0)
  rotation (0, 0, -{0} deg)
time
  end {2}
  step 0.1
)",
                     degrees, friction, end_s);
}

}  // namespace

class Incline : public Experiment {};

TEST_P(Incline, SticksWhereTheSlopeIsLessThanTheFriction) {
  const Record record = simulate(incline(20, 0.5, 10));  // tan 20° = 0.364
  const auto rows = record.of("crate");
  for (const Row& row : rows)
    EXPECT_LT((row.position_m - rows.front().position_m).norm(), 1e-6) << "t = " << row.time_s;
}

TEST_P(Incline, SlidesWhereItIsMore) {
  constexpr double kFriction = 0.3;
  const double angle = 30 * std::numbers::pi / 180;  // tan 30° = 0.577
  const double expected_m_s2 = kGravity_m_s2 * (std::sin(angle) - kFriction * std::cos(angle));
  const auto rows = simulate(incline(30, kFriction, 2)).of("crate");
  const Vec3 down(std::cos(angle), -std::sin(angle), 0);
  const Row& end = rows.back();
  const double t = end.time_s;
  EXPECT_NEAR(end.velocity_m_s.dot(down) / t, expected_m_s2, 1e-4 * expected_m_s2);
  EXPECT_NEAR(2 * (end.position_m - rows.front().position_m).dot(down) / (t * t), expected_m_s2,
              1e-4 * expected_m_s2);
  EXPECT_LT(end.angular_velocity_rad_s.norm(), 1e-6);
}

// Friction slows the sliding ball and turns it until it rolls: angular momentum about the contact stays, so v
// = 5/7 v0.
class SlidingBall : public Experiment {};

TEST_P(SlidingBall, EndsRollingAtFiveSeventhsOfItsSpeed) {
  constexpr double kSpeed_m_s = 7, kRadius_m = 0.5;
  const auto rows = simulate(R"(
world
  gravity (0, -9.81, 0)
object floor
  shape plane(normal = (0, 1, 0), offset = 0)
  motion static
  friction 0.3
object ball
  shape sphere(radius = 0.5)
  mass 2
  friction 0.3
  position (0, 0.5, 0)
  velocity (7, 0, 0)
time
  end 2
  step 0.05
)")
                        .of("ball");
  const Row& end = rows.back();
  EXPECT_NEAR(end.velocity_m_s.x(), 5.0 / 7 * kSpeed_m_s, 1e-4);
  EXPECT_NEAR(end.angular_velocity_rad_s.z(), -end.velocity_m_s.x() / kRadius_m, 1e-4);
  // It slides for 2 v0 / (7 μ g), decelerated by μ g.
  const double slide_s = 2 * kSpeed_m_s / (7 * 0.3 * kGravity_m_s2);
  for (const Row& row : rows) {
    if (row.time_s > slide_s) break;
    EXPECT_NEAR(row.velocity_m_s.x(), kSpeed_m_s - 0.3 * kGravity_m_s2 * row.time_s, 1e-4)
        << "t = " << row.time_s;
  }
}

ANIMADO_BOTH_WAYS(Incline);
ANIMADO_BOTH_WAYS(SlidingBall);

}  // namespace animado::experiments
