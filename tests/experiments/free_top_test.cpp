// A body that turns freely: its energy and its angular momentum stay, however it tumbles (Euler's equations;
// the intermediate axis is the unstable one that Dzhanibekov saw).
#include "laboratory.hpp"

namespace animado::experiments {
namespace {

const Vec3 kInertia(1, 2, 3);  // kg m², principal axes of the body

double energy_J(const Row& row) {
  const Vec3 w = row.orientation.conjugate() * row.angular_velocity_rad_s;
  return 0.5 * w.dot(kInertia.cwiseProduct(w));
}

Vec3 angular_momentum(const Row& row) {
  const Vec3 w = row.orientation.conjugate() * row.angular_velocity_rad_s;
  return row.orientation * kInertia.cwiseProduct(w);
}

std::string top(const std::string& end_s, const std::string& world) {
  return "world\n" + world + R"(
object top
  shape box(size = (1.2, 1, 0.6))
  mass 1
  moments of inertia (1, 2, 3)
  angular velocity (0.02, 1.5, 0.4)
time
  step )" +
         end_s + "\n  end " + end_s + "\n";
}

}  // namespace

class FreeTop : public Experiment {};

TEST_P(FreeTop, KeepsEnergyAndAngularMomentumFor100Seconds) {
  const Record record = simulate(top("100", ""));
  const Row &start = record.rows.front(), &end = record.rows.back();
  EXPECT_NEAR(energy_J(end) / energy_J(start), 1, 1e-9);
  EXPECT_LT((angular_momentum(end) - angular_momentum(start)).norm() / angular_momentum(start).norm(), 1e-9);
}

TEST_P(FreeTop, ConvergesWithTheFourthOrder) {
  // Against a run with a sixteenth of the step, whose error is 16⁴ times smaller.
  const auto end = [&](double step_s) {
    return simulate(top("2", "substep " + std::to_string(step_s))).rows.back().angular_velocity_rad_s;
  };
  const double step_s = 0.0625;
  const Vec3 exact = end(step_s / 16);
  const double coarse = (end(step_s) - exact).norm(), fine = (end(step_s / 2) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
}

ANIMADO_BOTH_WAYS(FreeTop);

}  // namespace animado::experiments
