// A ball that falls from h and bounces with restitution ε rises to ε²ⁿ h after n bounces.
#include <cmath>

#include "laboratory.hpp"
#include "scenes.hpp"

namespace animado::experiments {

class Bouncing : public Experiment {};

TEST_P(Bouncing, HeightsAreAGeometricSeries) {
  constexpr double kHeight_m = 2, kRestitution = 0.8, kGravity_m_s2 = 9.81, kRadius_m = 0.25;
  const Record record = simulate("world\n gravity (0, -9.81, 0)\n" + bouncing_ball("5.5", "0.01"));
  const auto impacts = record.impacts();
  ASSERT_GE(impacts.size(), 10u);
  // Between two bounces the ball is in free flight, so each frame tells the height that it reaches.
  for (const Row& row : record.of("ball")) {
    size_t bounces = 0;
    while (bounces < impacts.size() && impacts[bounces]["time_s"].get<double>() <= row.time_s) ++bounces;
    if (bounces > 10) break;
    const double v = row.velocity_m_s.y();
    const double height_m = row.position_m.y() - kRadius_m + v * v / (2 * kGravity_m_s2);
    EXPECT_NEAR(height_m, std::pow(kRestitution, 2.0 * static_cast<double>(bounces)) * kHeight_m, 1e-6)
        << "t = " << row.time_s;
  }
  // And the bounces come when they should: after √(2h/g), then each 2 ε^n √(2h/g) later.
  double expected_s = std::sqrt(2 * kHeight_m / kGravity_m_s2);
  for (size_t n = 0; n < 10; ++n) {
    EXPECT_NEAR(impacts[n]["time_s"].get<double>(), expected_s, 1e-8) << "bounce " << n;
    expected_s +=
        2 * std::pow(kRestitution, static_cast<double>(n + 1)) * std::sqrt(2 * kHeight_m / kGravity_m_s2);
  }
}

ANIMADO_BOTH_WAYS(Bouncing);

}  // namespace animado::experiments
