// The signed distance of two solids.
#pragma once

#include "base/spatial.hpp"
#include "colisao/solid.hpp"

namespace animado::colisao {

struct Gap {
  double gap_m;    // distance of the surfaces; negative, the depth, when they overlap
  Vec3 normal;     // world, unit, from b towards a: moving a by −gap along it makes them touch
  Vec3 point_a_m;  // world, nearest point of a's surface (deepest, when they overlap)
  Vec3 point_b_m;  // world, the same of b

  Vec3 point_m() const { return 0.5 * (point_a_m + point_b_m); }
};

// To rounding (about 1e-15 of the coordinates) for polyhedra, spheres, capsules and half-spaces; cylinders
// and cones to 1e-10 of the size when they are apart or touch, and to 1e-6 of it deep in each other. When the
// solids overlap it is the depth along the best axis (exact for polyhedra and anything against a half-space;
// for cylinders and cones the best of the maxima found from several starts). Two half-spaces are infinitely
// far apart.
Gap gap(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b);

}  // namespace animado::colisao
