#include "colisao/penetration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "colisao/gjk.hpp"

namespace animado::colisao {
namespace {

constexpr int kMostAscents = 32;
constexpr double kStraight_rad = 1e-10;    // a turn of the normal that is no longer worth a step
constexpr double kExtentRounding = 4e-15;  // of the extent
constexpr size_t kStarts = 8;              // the best of the start directions, from which it climbs
constexpr double kApart = 0.95;            // cosine: starts nearer to each other would climb the same hill
constexpr int kSpread = 64;
constexpr double kShallow = 1e-2;  // of the smaller size: a depth below this has no rival worth a search
// How far A is moved away from B, of the smaller size: less at every step, since the normal's error falls by
// lift / (lift + radius of curvature), and never so little that rounding turns the normal.
constexpr double kLift = 1.0 / 128, kLeastLift = 1e-4;

double size_of(const Placed& a, const Placed& b) {
  return std::min(a.solid.size_m(), b.solid.size_m());
}

double separation_along(const Placed& a, const Placed& b, const Vec3& normal) {
  return normal.dot(a.core_support(-normal) - b.core_support(normal));
}

// Where the best axis of curved solids may lie: the normals of faces, the axes of revolution, the line of the
// centres, and what is perpendicular to two of them.
std::vector<Vec3> start_directions(const Placed& a, const Placed& b) {
  std::vector<Vec3> starts, axes;
  const Vec3 line = a.position_m - b.position_m;
  if (line.norm() > 0) starts.push_back(line.normalized());
  for (const Placed* s : {&b, &a}) {
    if (const Polyhedron* p = s->solid.polyhedron()) {
      for (const Polyhedron::Face& face : p->faces) {
        const Vec3 outward = s->rotation * face.normal;
        starts.push_back(s == &b ? outward : Vec3(-outward));
      }
      for (const Polyhedron::Edge& e : p->edges) {
        axes.push_back(s->rotation *
                       (p->vertices_m[static_cast<size_t>(e.to)] - p->vertices_m[static_cast<size_t>(e.from)])
                           .normalized());
      }
    } else {
      axes.push_back(s->rotation.col(1));
      for (int k = 0; k < 3; ++k) {
        starts.push_back(s->rotation.col(k));
        starts.push_back(-s->rotation.col(k));
      }
    }
  }
  for (const Vec3& axis : axes) {
    const Vec3 across = line - axis.dot(line) * axis;
    if (across.norm() > 1e-9 * line.norm()) starts.push_back(across.normalized());
  }
  for (size_t i = 0; i < axes.size(); ++i) {
    for (size_t j = i + 1; j < axes.size(); ++j) {
      const Vec3 cross = axes[i].cross(axes[j]);
      if (cross.norm() < 1e-9) continue;
      starts.push_back(cross.normalized());
      starts.push_back(-cross.normalized());
    }
  }
  for (int i = 0; i < kSpread; ++i) {  // a spiral over the sphere
    const double z = 1 - (2.0 * i + 1) / kSpread, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    starts.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  return starts;
}

}  // namespace

Separation ascend(const Placed& a, const Placed& b, const Vec3& normal) {
  double lift = kLift * size_of(a, b);
  Separation best{separation_along(a, b, normal), normal, a.core_support(-normal), b.core_support(normal)};
  for (int step = 0; step < kMostAscents; ++step) {
    const double moved = lift + std::max(0.0, -best.separation_m);
    const Vec3 shift = moved * best.normal;
    const CoreDistance d = core_distance(a, b, shift, best.normal);
    if (d.overlap) break;
    // Second order in the error of the normal, where the separation along it would be first order at an edge.
    const double distance = d.separation.norm(), separation = distance - moved;
    if (step > 0 &&
        separation < best.separation_m - kExtentRounding * (a.solid.radius_m() + b.solid.radius_m()))
      break;
    const Vec3 next = d.separation / distance;
    const double turn = (next - best.normal).norm();
    best = {separation, next, d.point_a_m - shift, d.point_b_m};
    if (turn < kStraight_rad) break;
    lift = std::max(0.25 * lift, kLeastLift * size_of(a, b));
  }
  return best;
}

Separation penetration(const Placed& a, const Placed& b) {
  if (a.solid.polyhedron() && b.solid.polyhedron()) {
    const Axis axis = separating_axis(a, b);
    const double lift = kLift * size_of(a, b);
    const Vec3 shift = (lift - axis.separation_m) * axis.normal;
    const CoreDistance d = core_distance(a, b, shift, axis.normal);
    return {axis.separation_m, axis.normal, d.point_a_m - shift, d.point_b_m};
  }
  const std::vector<Vec3> starts = start_directions(a, b);
  std::vector<std::pair<double, size_t>> order;
  for (size_t i = 0; i < starts.size(); ++i) order.emplace_back(-separation_along(a, b, starts[i]), i);
  std::sort(order.begin(), order.end());

  Separation best = ascend(a, b, starts[order[0].second]);
  std::vector<Vec3> climbed{starts[order[0].second]};
  const double shallow = -kShallow * size_of(a, b);
  for (size_t k = 1; k < order.size() && climbed.size() < kStarts && best.separation_m < shallow; ++k) {
    const Vec3& start = starts[order[k].second];
    if (std::any_of(climbed.begin(), climbed.end(), [&](const Vec3& c) { return c.dot(start) > kApart; }))
      continue;
    climbed.push_back(start);
    const Separation other = ascend(a, b, start);
    if (other.separation_m > best.separation_m) best = other;
  }
  return best;
}

}  // namespace animado::colisao
