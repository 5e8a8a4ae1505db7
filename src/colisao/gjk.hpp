// The nearest points of two convex cores: the algorithm of Gilbert, Johnson and Keerthi ("A fast procedure
// for computing the distance between complex objects in three-dimensional space", IEEE J. Robotics and
// Automation 4(2), 1988).
//
// The Minkowski difference A − B holds the origin when the cores overlap; otherwise its point v nearest to
// the origin is the shortest vector from B to A. A simplex of support points is improved until no support
// lies farther towards the origin than v:
//   |v|² − v · w ≤ 2⁻⁵² |v|²,  w = s_A(−v) − s_B(v),
// or rounding ends the progress. Supports of curved cores crowd into slivers before that, and leave |v| wrong
// by up to 1e-8: slices.hpp then finishes the search.
#pragma once

#include "colisao/placed.hpp"

namespace animado::colisao {

struct CoreDistance {
  bool overlap;     // the cores share a point, to rounding; the rest is then void
  Vec3 separation;  // from b's nearest point to a's
  Vec3 point_a_m, point_b_m;
  double error_m;  // the distance is at most this much smaller
  int iterations;
};

// a is moved by `shift` first. `guess` points from b to a; any vector, zero too.
CoreDistance core_distance(const Placed& a, const Placed& b, const Vec3& shift, const Vec3& guess);

}  // namespace animado::colisao
