// Which pairs of bodies may meet between two states: those whose bounding boxes do (the paper's figure 3, in
// time).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "colisao/collider.hpp"

namespace animado::colisao {

using Pair = std::pair<int, int>;  // first < second

class BroadPhase {
 public:
  BroadPhase() = default;
  explicit BroadPhase(std::span<const Collider> bodies);  // which must outlive this

  // States of shape (13, bodies), rows as in base/state.hpp. The box of a body holds its bounding ball all
  // along the Hermite interpolant, enlarged by half the margin, so that a body which spins in place keeps its
  // box. Pairs sorted; bodies that may not meet are left out.
  std::vector<Pair> pairs_between(const double* from, const double* to, double step_s, double margin_m) const;

  // The same for one state.
  std::vector<Pair> pairs_at(const double* state, double margin_m) const {
    return pairs_between(state, state, 0, margin_m);
  }

 private:
  std::span<const Collider> bodies_;
  std::vector<double> radius_m_;  // infinite for a half-space
  std::vector<int> resting_;      // fixed bodies of finite size
};

}  // namespace animado::colisao
