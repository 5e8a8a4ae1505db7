// Forces by expression: a harmonic spring and Kepler's orbit.
#include <cmath>
#include <numbers>

#include "laboratory.hpp"
#include "scenes.hpp"

namespace animado::experiments {

class HarmonicSpring : public Experiment {};

TEST_P(HarmonicSpring, HasThePeriodThatTheFormulaSays) {
  // spring.k is chosen for a period of one second.
  const auto record = simulate(R"(
spring.k = 4*pi^2*weight.mass
object weight
  shape cube(edge = 0.2)
  mass 1.5
  position (0.3, 0, 0)
  force (-spring.k*weight.position.x, 0, 0)
time
  end 5
  step 0.125
)");
  const double energy_J = 0.5 * 4 * std::numbers::pi * std::numbers::pi * 1.5 * 0.3 * 0.3;
  for (const Row& row : record.rows) {
    const double phase = 2 * std::numbers::pi * row.time_s;
    EXPECT_NEAR(row.position_m.x(), 0.3 * std::cos(phase), 1e-8) << "t = " << row.time_s;
    const double now_J = 0.5 * 1.5 * row.velocity_m_s.squaredNorm() +
                         0.5 * 4 * std::numbers::pi * std::numbers::pi * 1.5 * row.position_m.squaredNorm();
    EXPECT_NEAR(now_J / energy_J, 1, 1e-8) << "t = " << row.time_s;
  }
  EXPECT_NEAR(record.summary["energy"]["residual"].get<double>(), 0, 1e-8 * energy_J);
}

class KeplerOrbit : public Experiment {};

TEST_P(KeplerOrbit, Closes) {
  const auto rows = simulate(kOrbit).of("planet");
  const Row &start = rows.front(), &end = rows.back();
  EXPECT_LT((end.position_m - start.position_m).norm(), 1e-8);
  EXPECT_LT((end.velocity_m_s - start.velocity_m_s).norm(), 1e-7);
  // The aphelion is half a period away.
  EXPECT_LT((rows[8].position_m - Vec3(-1.3, 0, 0)).norm(), 1e-8);
}

ANIMADO_BOTH_WAYS(HarmonicSpring);
ANIMADO_BOTH_WAYS(KeplerOrbit);

}  // namespace animado::experiments
