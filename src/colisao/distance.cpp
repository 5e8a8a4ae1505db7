#include "colisao/distance.hpp"

#include <algorithm>
#include <limits>

#include "colisao/gjk.hpp"
#include "colisao/penetration.hpp"

namespace animado::colisao {
namespace {

// Cores nearer than this part of the size have their normal refined by ascent: the shortest vector alone
// would lose it in rounding.
constexpr double kClose = 1e-4;

Gap flipped(const Gap& g) {
  return {g.gap_m, -g.normal, g.point_b_m, g.point_a_m};
}

Gap above_plane(const Solid& a, const Pose& pose_a, const HalfSpace& plane, const Pose& pose_b) {
  const Vec3 normal = pose_b.orientation * plane.normal;
  const Vec3 lowest =
      pose_a.position_m + pose_a.orientation * a.support(pose_a.orientation.conjugate() * -normal);
  const double height = normal.dot(lowest - pose_b.position_m) - plane.offset_m;
  return {height, normal, lowest, lowest - height * normal};
}

Separation separate(const Placed& a, const Placed& b) {
  const CoreDistance d = core_distance(a, b, Vec3::Zero(), a.position_m - b.position_m);
  if (d.overlap) return penetration(a, b);
  const double distance = d.separation.norm();
  const Vec3 normal = d.separation / distance;
  const bool sharp = a.solid.core_radius_m() == 0 && b.solid.core_radius_m() == 0;
  if (sharp && distance < kClose * std::min(a.solid.size_m(), b.solid.size_m())) return ascend(a, b, normal);
  return {distance, normal, d.point_a_m, d.point_b_m};
}

}  // namespace

Gap gap(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b) {
  if (a.half_space() && b.half_space()) {
    return {std::numeric_limits<double>::infinity(), Vec3::UnitY(), pose_a.position_m, pose_b.position_m};
  }
  if (b.half_space()) return above_plane(a, pose_a, *b.half_space(), pose_b);
  if (a.half_space()) return flipped(above_plane(b, pose_b, *a.half_space(), pose_a));

  const Vec3 origin = pose_b.position_m;
  const Separation s = separate(Placed(a, pose_a, origin), Placed(b, pose_b, origin));
  return {s.separation_m - a.core_radius_m() - b.core_radius_m(), s.normal,
          origin + s.point_a_m - a.core_radius_m() * s.normal,
          origin + s.point_b_m + b.core_radius_m() * s.normal};
}

}  // namespace animado::colisao
