// Newton's cradle: five balls that touch, the first comes with v0; the last one leaves with it, and the
// others rest ("Reflections on simultaneous impact", Smith et al. 2012).
#include "laboratory.hpp"

namespace animado::experiments {

class NewtonCradle : public Experiment {};

TEST_P(NewtonCradle, HandsItsMomentumOn) {
  std::string scene;
  for (int i = 0; i < 5; ++i) {
    scene += fmt::format(R"(
object ball{0}
  shape sphere(radius = 0.5)
  mass 1
  restitution 1
  position ({1}, 0, 0)
  velocity ({2}, 0, 0)
)",
                         i, i == 0 ? -2.0 : i, i == 0 ? 1.5 : 0.0);
  }
  const Record record = simulate(scene + "\ntime\n  end 2\n  step 0.25\n");
  for (int i = 0; i < 5; ++i) {
    const Row end = record.of(fmt::format("ball{}", i)).back();
    EXPECT_LT((end.velocity_m_s - Vec3(i == 4 ? 1.5 : 0, 0, 0)).norm(), 1e-6) << "ball " << i;
  }
}

// A box that lands flat meets the floor with four corners at once, and does not spin.
class FlatLanding : public Experiment {};

TEST_P(FlatLanding, DoesNotSpin) {
  const auto rows = simulate(R"(
world
  gravity (0, -9.81, 0)
object floor
  shape plane(normal = (0, 1, 0), offset = 0)
  motion static
  restitution 1
object crate
  shape box(size = (1, 0.5, 0.8))
  mass 2
  restitution 0.6
  position (0, 1.25, 0)
time
  end 1
  step 0.05
)")
                        .of("crate");
  for (const Row& row : rows) {
    EXPECT_LT(row.angular_velocity_rad_s.norm(), 1e-9) << "t = " << row.time_s;
    EXPECT_LT(std::abs(row.position_m.x()) + std::abs(row.position_m.z()), 1e-9) << "t = " << row.time_s;
  }
}

ANIMADO_BOTH_WAYS(NewtonCradle);
ANIMADO_BOTH_WAYS(FlatLanding);

}  // namespace animado::experiments
