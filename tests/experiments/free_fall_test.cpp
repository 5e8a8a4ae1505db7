// Uniform gravity: x = x0 + v0 t + g t²/2, which RK4 integrates without error.
#include "laboratory.hpp"

namespace animado::experiments {

class FreeFall : public Experiment {};

TEST_P(FreeFall, FollowsTheParabola) {
  const Record record = simulate(R"(
world
  gravity (0, -9.81, 0)
object stone
  shape sphere(radius = 0.1)
  mass 2
  position (1, 100, -2)
  velocity (3, 4, 5)
  angular velocity (0.1, 0.2, 0.3)
time
  end 4
  step 0.25
)");
  const Vec3 x0(1, 100, -2), v0(3, 4, 5), g(0, -9.81, 0);
  ASSERT_EQ(record.rows.size(), 17u);
  for (const Row& row : record.rows) {
    const double t = row.time_s;
    const Vec3 x = x0 + v0 * t + 0.5 * g * t * t, v = v0 + g * t;
    EXPECT_LT((row.position_m - x).norm(), 1e-11) << "t = " << t;
    EXPECT_LT((row.velocity_m_s - v).norm(), 1e-11) << "t = " << t;
  }
  EXPECT_NEAR(record.summary["energy"]["residual"].get<double>(), 0, 1e-10);
}

// The centre of mass moves straight while the body turns about it, wherever the frame's origin is.
class CenterOfMassOffOrigin : public Experiment {};

TEST_P(CenterOfMassOffOrigin, MovesStraight) {
  const Record record = simulate(R"(
object hammer
  shape box(size = (0.4, 1.2, 0.3))
  mass 3
  center of mass (0.1, 0.45, -0.05)
  moments of inertia (0.5, 0.2, 0.6)
  products of inertia (0.02, -0.01, 0.03)
  position (0, 1, 0)
  velocity (1, 0.5, -0.2)
  angular velocity (1, -2, 3)
time
  end 5
  step 0.1
)");
  const Vec3 c(0.1, 0.45, -0.05);
  const auto center = [&](const Row& row) { return Vec3(row.position_m + row.orientation * c); };
  const Row& start = record.rows.front();
  const Vec3 velocity = start.velocity_m_s + start.angular_velocity_rad_s.cross(start.orientation * c);
  for (const Row& row : record.rows) {
    EXPECT_LT((center(row) - center(start) - velocity * row.time_s).norm(), 1e-10) << "t = " << row.time_s;
  }
}

ANIMADO_BOTH_WAYS(FreeFall);
ANIMADO_BOTH_WAYS(CenterOfMassOffOrigin);

}  // namespace animado::experiments
