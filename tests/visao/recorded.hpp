// Runs made by hand, for tests that look at them.
#pragma once

#include "controle/results/recorded_run.hpp"

namespace animado::visao {

// Frames a tenth of a second apart; body k of frame f is at places_m[f][k].
inline controle::RecordedRun recorded(std::vector<controle::RecordedBody> bodies,
                                      const std::vector<std::vector<Vec3>>& places_m) {
  controle::RecordedRun run;
  run.bodies = std::move(bodies);
  for (const auto& frame : places_m) {
    run.times_s.push_back(0.1 * static_cast<double>(run.times_s.size()));
    run.facts.push_back({.time_s = run.times_s.back()});
    for (const Vec3& place_m : frame) {
      controle::RecordedState& state = run.states.emplace_back();
      state.pose.position_m = place_m;
    }
  }
  return run;
}

}  // namespace animado::visao
