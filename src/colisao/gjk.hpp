// The nearest points of two convex cores: the algorithm of Gilbert, Johnson and Keerthi ("A fast procedure
// for computing the distance between complex objects in three-dimensional space", IEEE J. Robotics and
// Automation 4(2), 1988).
//
// The Minkowski difference A − B holds the origin when the cores overlap; otherwise its point v nearest to
// the origin is the shortest vector from B to A. A simplex of support points is improved until no support
// lies farther towards the origin than v:
//   |v|² − v · w ≤ 1e-14 |v|²,  w = s_A(−v) − s_B(v),
// which bounds the error of |v| by 1e-14 of it; or until rounding ends the progress.
#pragma once

#include "colisao/placed.hpp"

namespace animado::colisao {

struct CoreDistance {
  bool overlap;     // the cores share a point, to rounding; the rest is then void
  Vec3 separation;  // from b's nearest point to a's
  Vec3 point_a_m, point_b_m;
  int iterations;
};

// a is moved by `shift` first. `guess` points from b to a; any vector, zero too.
CoreDistance core_distance(const Placed& a, const Placed& b, const Vec3& shift, const Vec3& guess);

}  // namespace animado::colisao
