// The separation of two cores along the best axis, for those that overlap or all but touch.
//
// s(n) = min over A of n · x − max over B of n · x, n unit, is maximised by ascent: A is moved along n until
// it is a little away from B; the direction m of the shortest way between them then maximises s(m) + δ m · n,
// hence
//   s(m) ≥ s(n) + δ (1 − m · n) ≥ s(n).
// The estimate |shortest way| − δ is never above the maximum and, near it, below it only by the square of the
// error of n. Every step is one distance of separated cores (gjk.hpp), which is well conditioned where a
// touching one is not. Two polyhedra need no ascent to find the depth: separating_axes.hpp has it exactly.
#pragma once

#include "colisao/separating_axes.hpp"

namespace animado::colisao {

struct Separation {
  double separation_m;  // largest s(n) found; negative when the cores overlap
  Vec3 normal;
  Vec3 point_a_m, point_b_m;  // of the cores; their difference is separation · normal
};

// The maximum that is reached from a unit normal (from b to a).
Separation ascend(const Placed& a, const Placed& b, const Vec3& normal);

// The best of the maxima, for cores that overlap.
Separation penetration(const Placed& a, const Placed& b);

}  // namespace animado::colisao
