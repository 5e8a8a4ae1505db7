#include "colisao/sweep.hpp"

#include "base/state.hpp"
#include "colisao/distance.hpp"
#include "colisao/time_of_impact.hpp"

namespace animado::colisao {

SweepResult sweep(std::span<const Collider> bodies, const BroadPhase& broad_phase, const double* from,
                  const double* to, double step_s) {
  const size_t n = bodies.size();
  const std::vector<Pair> pairs = broad_phase.pairs_between(from, to, step_s, kNear_m);
  SweepResult result;
  result.time_s = step_s;
  result.candidates = static_cast<int64_t>(pairs.size());
  const auto path = [&](size_t i) { return Path(load_body(from, n, i), load_body(to, n, i), step_s); };
  for (const auto& [a, b] : pairs) {
    const auto ia = static_cast<size_t>(a), ib = static_cast<size_t>(b);
    const Impact impact =
        time_of_impact(bodies[ia].solid, path(ia), bodies[ib].solid, path(ib), result.time_s);
    result.sinking = result.sinking || impact.sinking;
    result.near = result.near || impact.end_gap_m <= kNear_m;
    // A pair that meets only as late as the best is not earlier: the first of equals stays.
    if (!impact.hit || (result.hit && impact.time_s >= result.time_s)) continue;
    result.hit = result.near = true;
    result.time_s = impact.time_s;
    result.a = a;
    result.b = b;
  }
  return result;
}

}  // namespace animado::colisao
