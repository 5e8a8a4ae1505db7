#include "colisao/separating_axes.hpp"

#include <limits>
#include <vector>

namespace animado::colisao {
namespace {

// An edge axis must beat a face by this much of the size: where they tie, the face tells more.
constexpr double kFaceBias = 1e-10;

struct WorldEdge {
  Vec3 point, along, left, right;
};

std::vector<WorldEdge> edges_of(const Placed& s) {
  const Polyhedron& p = *s.solid.polyhedron();
  std::vector<WorldEdge> edges;
  edges.reserve(p.edges.size());
  for (const Polyhedron::Edge& e : p.edges) {
    const Vec3 from = s.to_world(p.vertices_m[static_cast<size_t>(e.from)]);
    const Vec3 to = s.to_world(p.vertices_m[static_cast<size_t>(e.to)]);
    edges.push_back({from, to - from, s.rotation * p.faces[static_cast<size_t>(e.left)].normal,
                     s.rotation * p.faces[static_cast<size_t>(e.right)].normal});
  }
  return edges;
}

// The best face of `owner`: how far the other solid lies in front of it. The normal looks out of the owner.
Axis best_face(const Placed& owner, const Placed& other) {
  Axis best{Vec3::Zero(), -std::numeric_limits<double>::infinity()};
  for (const Polyhedron::Face& face : owner.solid.polyhedron()->faces) {
    const Vec3 normal = owner.rotation * face.normal;
    const double separation = normal.dot(other.core_support(-normal) - owner.position_m) - face.offset_m;
    if (separation > best.separation_m) best = {normal, separation};
  }
  return best;
}

// Whether the arc of one edge's normals crosses that of the other's negated ones: only then does the pair
// make a face of A − B.
bool arcs_cross(const WorldEdge& ea, const WorldEdge& eb) {
  const Vec3 c = -eb.left, d = -eb.right;
  const Vec3 plane_ab = ea.right.cross(ea.left), plane_cd = d.cross(c);
  const double cba = c.dot(plane_ab), dba = d.dot(plane_ab);
  const double adc = ea.left.dot(plane_cd), bdc = ea.right.dot(plane_cd);
  return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

}  // namespace

Axis separating_axis(const Placed& a, const Placed& b) {
  Axis best = best_face(b, a);
  const Axis of_a = best_face(a, b);
  const double bias = kFaceBias * std::min(a.solid.size_m(), b.solid.size_m());
  if (of_a.separation_m > best.separation_m + bias) best = {-of_a.normal, of_a.separation_m};

  const std::vector<WorldEdge> edges_a = edges_of(a), edges_b = edges_of(b);
  double to_beat = best.separation_m + bias;
  for (const WorldEdge& ea : edges_a) {
    for (const WorldEdge& eb : edges_b) {
      if (!arcs_cross(ea, eb)) continue;
      const Vec3 cross = ea.along.cross(eb.along);
      const double length = cross.norm();
      if (length <= 1e-12 * ea.along.norm() * eb.along.norm()) continue;
      const Vec3 normal = cross / (cross.dot(eb.left + eb.right) > 0 ? length : -length);
      const double separation = normal.dot(ea.point - eb.point);
      if (separation > to_beat) {
        to_beat = separation;
        best = {normal, separation};
      }
    }
  }
  return best;
}

}  // namespace animado::colisao
