#include "controle/divergence.hpp"

#include <algorithm>

#include "base/finite.hpp"
#include "base/state.hpp"
#include "controle/scene/limits.hpp"

namespace animado::controle {
namespace {

double most_in(size_t row) {
  if (row >= kWx) return kFastestTurn_rad_s;
  return row >= kVx ? kSpeedOfLight_m_s : kUniverse_m;
}

}  // namespace

Error divergence(const Scene& scene, size_t index, double time_s) {
  const Body& body = scene.bodies[index];
  const auto what = [&](const char* of) {
    return fmt::format("the {} of `{}` diverged at t = {:.9g} s", of, body.name, time_s);
  };
  if (const auto& path = body.path_position ? body.path_position : body.path_rotation) {
    return {Code::diverged, what("path"), scene.where(path->place),
            "Look for a division by zero, or a root or a logarithm of a negative number."};
  }
  return {Code::diverged, what("motion"), scene.path,
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
