// The paper's rules for the collision plane (section 3.4.2, after Moore and Wilhelms 1988): a vertex on a
// face: the face; two edges: the cross product of the edges; two vertices: the line that joins them, and when
// they coincide the line of the origins of the frames. A curved surface counts as a face where it is touched.
//
// A feature is taken for level when its tilt lifts its far side by less than about the margin: a box that
// rocks by 1e-9 rad still stands on its four corners. Each contact has its own gap, so nothing is rounded by
// that.
#include "colisao/manifold.hpp"

#include <algorithm>
#include <cstdint>

#include "colisao/distance.hpp"
#include "colisao/overlap.hpp"
#include "colisao/polyhedra.hpp"

namespace animado::colisao {
namespace {

constexpr double kLeastTilt = 1e-7, kMostTilt = 0.05;  // rad
constexpr double kCoincident_m = 1e-9;                 // vertices and edges nearer than this are one

struct PairInput {
  int ia, ib;
  const Solid &a, &b;
  const Pose &pose_a, &pose_b;
  double margin_m;
};

Feature feature_towards(const Solid& solid, const Pose& pose, const Vec3& direction, double tilt) {
  Feature f = solid.feature(pose.orientation.conjugate() * direction, tilt);
  for (Vec3& p : f.points_m) p = pose.to_world(p);
  f.normal = pose.orientation * f.normal;
  f.centre_m = pose.to_world(f.centre_m);
  return f;
}

int feature_number(const Feature& a, const Feature& b, int code) {
  const auto mix = (static_cast<uint32_t>(a.id) * 65599u + static_cast<uint32_t>(b.id)) * 65599u;
  return static_cast<int>((mix + static_cast<uint32_t>(code)) & 0x7FFFFFFFu);
}

// A face defines the plane; of two the one that is more exactly level, b's when they tie. Without a face it
// is the given normal.
Vec3 plane_normal(const Feature& a, const Feature& b, const Vec3& normal) {
  const double tilt_a = a.is_face() ? (a.normal + normal).norm() : 1;
  const double tilt_b = b.is_face() ? (b.normal - normal).norm() : 1;
  if (b.is_face() && tilt_b <= tilt_a + 1e-9) return b.normal;
  if (a.is_face()) return -a.normal;
  return normal;
}

ContactKind kind_of(const Feature& a, const Feature& b) {
  if (a.is_face() || b.is_face() || !a.sharp || !b.sharp) return ContactKind::vertex_face;
  if (a.points_m.size() == 1 && b.points_m.size() == 1) return ContactKind::vertex_vertex;
  return ContactKind::edge_edge;
}

// The normal of edges that cross is their cross product; the sign is that of the given normal.
Vec3 edge_normal(const Feature& a, const Feature& b, const Vec3& normal, double tilt) {
  if (a.points_m.size() != 2 || b.points_m.size() != 2) return normal;
  const Vec3 u = (a.points_m[1] - a.points_m[0]).normalized(),
             v = (b.points_m[1] - b.points_m[0]).normalized();
  const Vec3 cross = u.cross(v);
  if (cross.norm() <= tilt) return normal;
  return cross.normalized() * (cross.dot(normal) < 0 ? -1 : 1);
}

Vec3 line_of_origins(const PairInput& in, const Vec3& otherwise) {
  const Vec3 line = in.pose_a.position_m - in.pose_b.position_m;
  return line.norm() > kCoincident_m ? line.normalized() : otherwise;
}

// Two polyhedra that meet in one vertex or along one edge only have no face to define the plane, although a
// face may be level: the line of the origins does, across the edge if there is one. False when they meet
// otherwise.
bool meet_at_rim(const PairInput& in, const Vec3& normal, Vec3* rim_normal, ContactKind* kind) {
  if (!in.a.polyhedron() || !in.b.polyhedron()) return false;
  const std::vector<Crossing> all =
      crossings(*in.a.polyhedron(), in.pose_a, *in.b.polyhedron(), in.pose_b, kCoincident_m);
  if (all.size() == 1 && all[0].kind == Meeting::vertex_vertex) {
    *rim_normal = line_of_origins(in, normal);
    *kind = ContactKind::vertex_vertex;
    return true;
  }
  const bool along_edge = all.size() == 2 && std::all_of(all.begin(), all.end(), [](const Crossing& c) {
                            return c.kind == Meeting::edge_overlap || c.kind == Meeting::vertex_vertex ||
                                   c.kind == Meeting::vertex_edge;
                          });
  if (!along_edge) return false;
  const Vec3 edge = (all[1].point_m - all[0].point_m).normalized(), line = line_of_origins(in, normal);
  const Vec3 across = line - edge.dot(line) * edge;
  *rim_normal = across.norm() > kCoincident_m ? across.normalized() : normal;
  *kind = ContactKind::edge_edge;
  return true;
}

void on_plane(const PairInput& in, const Gap& g, double tilt, std::vector<Contact>& out) {
  const bool plane_is_b = in.b.half_space() != nullptr;
  const Feature f = plane_is_b ? feature_towards(in.a, in.pose_a, -g.normal, tilt)
                               : feature_towards(in.b, in.pose_b, g.normal, tilt);
  const Vec3& foot = plane_is_b ? g.point_b_m : g.point_a_m;
  const Vec3 up = plane_is_b ? g.normal : Vec3(-g.normal);
  for (size_t k = 0; k < f.points_m.size(); ++k) {
    const double height = up.dot(f.points_m[k] - foot);
    if (height > in.margin_m) continue;
    out.push_back({in.ia, in.ib, f.points_m[k] - 0.5 * height * up, g.normal, height,
                   ContactKind::vertex_face, feature_number(f, f, static_cast<int>(k))});
  }
}

void between(const PairInput& in, const Gap& g, double tilt, std::vector<Contact>& out) {
  const Feature fa = feature_towards(in.a, in.pose_a, -g.normal, tilt);
  const Feature fb = feature_towards(in.b, in.pose_b, g.normal, tilt);
  if (fa.points_m.size() == 1 && fb.points_m.size() == 1) return;
  Vec3 normal = edge_normal(fa, fb, plane_normal(fa, fb, g.normal), tilt);
  ContactKind kind = kind_of(fa, fb);
  const double tolerance = 1e-9 * std::min(in.a.size_m(), in.b.size_m());
  const Corners corners = overlap(fa, fb, normal, tolerance, tilt);
  const bool thin = corners.size() <= 2 && fa.is_face() && fb.is_face();
  const bool at_rim = corners.size() == 1 || thin;
  if (at_rim && std::abs(g.gap_m) <= kCoincident_m) meet_at_rim(in, normal, &normal, &kind);
  for (const Corner& c : corners) {
    if (c.gap_m > in.margin_m) continue;
    out.push_back({in.ia, in.ib, c.point_m, normal, c.gap_m, kind, feature_number(fa, fb, c.code)});
  }
}

void at_nearest_points(const PairInput& in, const Gap& g, double tilt, std::vector<Contact>& out) {
  const Feature fa = feature_towards(in.a, in.pose_a, -g.normal, tilt);
  const Feature fb = feature_towards(in.b, in.pose_b, g.normal, tilt);
  Vec3 normal = g.normal;
  ContactKind kind = kind_of(fa, fb);
  if (std::abs(g.gap_m) <= kCoincident_m) meet_at_rim(in, g.normal, &normal, &kind);
  out.push_back({in.ia, in.ib, g.point_m(), normal, g.gap_m, kind, feature_number(fa, fb, 0)});
}

}  // namespace

void manifold(int ia, const Solid& a, const Pose& pose_a, int ib, const Solid& b, const Pose& pose_b,
              double margin_m, std::vector<Contact>& out) {
  const Gap g = gap(a, pose_a, b, pose_b);
  if (g.gap_m > margin_m) return;
  const PairInput in{ia, ib, a, b, pose_a, pose_b, margin_m};
  const double tilt = std::clamp(2 * margin_m / std::min(a.size_m(), b.size_m()), kLeastTilt, kMostTilt);
  const size_t before = out.size();
  if (a.half_space() || b.half_space()) {
    on_plane(in, g, tilt, out);
  } else {
    between(in, g, tilt, out);
  }
  if (out.size() == before) at_nearest_points(in, g, tilt, out);
}

}  // namespace animado::colisao
