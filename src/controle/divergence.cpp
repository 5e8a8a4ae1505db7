#include "controle/divergence.hpp"

#include <algorithm>

#include "base/finite.hpp"
#include "base/state.hpp"

namespace animado::controle {
namespace {

constexpr double kUniverse_m = 1e27;
constexpr double kSpeedOfLight_m_s = 299792458;
constexpr double kFastestTurn_rad_s = 3e23;

double most_in(size_t row) {
  if (row >= kWx) return kFastestTurn_rad_s;
  return row >= kVx ? kSpeedOfLight_m_s : kUniverse_m;
}

}  // namespace

Error divergence(const Scene& scene, size_t body, double time_s) {
  return {Code::diverged,
          fmt::format("the motion of `{}` diverged at t = {:.9g} s", scene.bodies[body].name, time_s),
          scene.path,
          "A force that grows with the motion it makes, or a step too long for a stiff spring: look at the "
          "object's force and torque, or give `world` a smaller `substep`."};
}

void check_state(const Scene& scene, const double* state, double time_s) {
  const size_t bodies = scene.bodies.size();
  for (size_t row = 0; row < kStateRows; ++row) {
    const double most = most_in(row);
    const std::span<const double> values(state + row * bodies, bodies);
    if (all_within(values, most)) continue;
    const auto at = std::ranges::find_if(values, [&](double v) { return !(std::abs(v) <= most); });
    if (at == values.end()) continue;  // who shares the memory wrote meanwhile
    throw divergence(scene, static_cast<size_t>(at - values.begin()), time_s);
  }
}

}  // namespace animado::controle
