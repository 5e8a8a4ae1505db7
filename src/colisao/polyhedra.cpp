#include "colisao/polyhedra.hpp"

#include <algorithm>
#include <cmath>

namespace animado::colisao {
namespace {

using Vertices = std::vector<Vec3>;

struct Bounds {
  Vec3 low, high;
};

Bounds bounds_of(const Vertices& points) {
  Bounds b{points[0], points[0]};
  for (const Vec3& p : points) b = {b.low.cwiseMin(p), b.high.cwiseMax(p)};
  return b;
}

bool meet(const Bounds& a, const Bounds& b, double tolerance) {
  return (a.low.array() <= b.high.array() + tolerance).all() &&
         (b.low.array() <= a.high.array() + tolerance).all();
}

struct WorldFace {
  Vertices corners;
  Vec3 normal;
  Bounds bounds;

  double height(const Vec3& p) const { return normal.dot(p - corners[0]); }
  const Vec3& next(size_t k) const { return corners[(k + 1) % corners.size()]; }
  size_t before(size_t k) const { return (k + corners.size() - 1) % corners.size(); }
};

struct WorldSegment {
  Vec3 from, to;
  Bounds bounds;
};

struct WorldPolyhedron {
  Vertices vertices;
  std::vector<WorldFace> faces;
  std::vector<WorldSegment> edges;

  WorldPolyhedron(const Polyhedron& p, const Pose& pose) {
    for (const Vec3& v : p.vertices_m) vertices.push_back(pose.to_world(v));
    const auto vertex = [&](int i) { return vertices[static_cast<size_t>(i)]; };
    for (const Polyhedron::Face& face : p.faces) {
      Vertices corners;
      for (int i : face.vertices) corners.push_back(vertex(i));
      faces.push_back({corners, pose.orientation * face.normal, bounds_of(corners)});
    }
    for (const Polyhedron::Edge& e : p.edges) {
      edges.push_back({vertex(e.from), vertex(e.to), bounds_of({vertex(e.from), vertex(e.to)})});
    }
  }

  bool holds(const Vec3& p) const {
    return std::all_of(faces.begin(), faces.end(), [&](const WorldFace& f) { return f.height(p) <= 0; });
  }
};

double distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double s = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - from - s * along).norm();
}

// Whether two segments share more than a point.
bool run_along(const WorldSegment& e, const Vec3& c, const Vec3& d, double tolerance) {
  const double length = (e.to - e.from).norm();
  const Vec3 along = (e.to - e.from) / length;
  if (along.cross(c - e.from).norm() > tolerance || along.cross(d - e.from).norm() > tolerance) return false;
  const double on_c = along.dot(c - e.from), on_d = along.dot(d - e.from);
  return std::min(length, std::max(on_c, on_d)) - std::max(0.0, std::min(on_c, on_d)) > 2 * tolerance;
}

// Where a point of a face's plane lies in the face.
struct Place {
  enum class Where { outside, interior, border, corner } where;
  size_t index;  // border from corner `index` to the next, or the corner
};

Place place_in(const WorldFace& face, const Vec3& p, double tolerance) {
  for (size_t k = 0; k < face.corners.size(); ++k) {
    if ((p - face.corners[k]).norm() <= tolerance) return {Place::Where::corner, k};
  }
  for (size_t k = 0; k < face.corners.size(); ++k) {
    if (distance_to_segment(p, face.corners[k], face.next(k)) <= tolerance) return {Place::Where::border, k};
  }
  for (size_t k = 0; k < face.corners.size(); ++k) {
    const Vec3 inward = face.normal.cross(face.next(k) - face.corners[k]);
    if (inward.dot(p - face.corners[k]) < 0) return {Place::Where::outside, 0};
  }
  return {Place::Where::interior, 0};
}

class EdgesOnFaces {
 public:
  EdgesOnFaces(double tolerance, std::vector<Crossing>& found) : tolerance_(tolerance), found_(found) {}

  void test(const WorldSegment& edge, const WorldFace& face) {
    if (!meet(edge.bounds, face.bounds, tolerance_)) return;
    const double from = face.height(edge.from), to = face.height(edge.to);
    const bool from_in_plane = std::abs(from) <= tolerance_, to_in_plane = std::abs(to) <= tolerance_;
    if (from_in_plane) take(edge.from, edge, face);
    if (to_in_plane) take(edge.to, edge, face);
    if (from_in_plane && to_in_plane) {
      within_plane(edge, face);
    } else if (!from_in_plane && !to_in_plane && (from > 0) != (to > 0)) {
      take(edge.from + from / (from - to) * (edge.to - edge.from), edge, face);
    }
  }

 private:
  // An edge in the plane of a face: it meets the face's border at corners and where it crosses.
  void within_plane(const WorldSegment& edge, const WorldFace& face) {
    for (size_t k = 0; k < face.corners.size(); ++k) {
      const Vec3 &c = face.corners[k], &d = face.next(k);
      if (distance_to_segment(c, edge.from, edge.to) <= tolerance_) take(c, edge, face);
      const Vec3 side = face.normal.cross(d - c).normalized();
      const double from = side.dot(edge.from - c), to = side.dot(edge.to - c);
      if (std::min(from, to) < -tolerance_ && std::max(from, to) > tolerance_) {
        take(edge.from + from / (from - to) * (edge.to - edge.from), edge, face);
      }
    }
  }

  void take(const Vec3& p, const WorldSegment& edge, const WorldFace& face) {
    const Place place = place_in(face, p, tolerance_);
    if (place.where == Place::Where::outside) return;
    const bool at_vertex = (p - edge.from).norm() <= tolerance_ || (p - edge.to).norm() <= tolerance_;
    keep({kind(at_vertex, place, edge, face), p});
  }

  Meeting kind(bool at_vertex, const Place& place, const WorldSegment& edge, const WorldFace& face) const {
    if (place.where == Place::Where::interior) return at_vertex ? Meeting::vertex_face : Meeting::edge_face;
    const bool at_corner = place.where == Place::Where::corner;
    if (at_vertex && at_corner) return Meeting::vertex_vertex;
    const auto along = [&](size_t k) { return run_along(edge, face.corners[k], face.next(k), tolerance_); };
    if (along(place.index) || (at_corner && along(face.before(place.index)))) return Meeting::edge_overlap;
    return at_vertex || at_corner ? Meeting::vertex_edge : Meeting::edge_edge;
  }

  // A point is found once for every edge and face that share it: the most particular kind stays.
  void keep(const Crossing& crossing) {
    const auto rank = [](Meeting kind) {
      switch (kind) {
        case Meeting::vertex_vertex:
          return 6;
        case Meeting::edge_overlap:
          return 5;
        case Meeting::vertex_edge:
          return 4;
        case Meeting::edge_edge:
          return 3;
        case Meeting::vertex_face:
          return 2;
        case Meeting::edge_face:
          return 1;
        case Meeting::inside:
          return 0;
      }
      return 0;
    };
    for (Crossing& known : found_) {
      if ((known.point_m - crossing.point_m).norm() > 4 * tolerance_) continue;
      if (rank(crossing.kind) > rank(known.kind)) known = crossing;
      return;
    }
    found_.push_back(crossing);
  }

  double tolerance_;
  std::vector<Crossing>& found_;
};

}  // namespace

std::vector<Crossing> crossings(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b,
                                const Pose& pose_b, double tolerance_m) {
  const WorldPolyhedron in_a(a, pose_a), in_b(b, pose_b);
  std::vector<Crossing> found;
  const Bounds box_a = bounds_of(in_a.vertices), box_b = bounds_of(in_b.vertices);
  if (!meet(box_a, box_b, tolerance_m)) return found;
  EdgesOnFaces tests(tolerance_m, found);
  const auto one_way = [&](const WorldPolyhedron& edges_of, const WorldPolyhedron& faces_of,
                           const Bounds& box) {
    for (const WorldSegment& edge : edges_of.edges) {
      if (!meet(edge.bounds, box, tolerance_m)) continue;
      for (const WorldFace& face : faces_of.faces) tests.test(edge, face);
    }
  };
  one_way(in_a, in_b, box_b);
  one_way(in_b, in_a, box_a);
  if (!found.empty()) return found;
  if (in_b.holds(in_a.vertices[0])) found.push_back({Meeting::inside, in_a.vertices[0]});
  if (in_a.holds(in_b.vertices[0])) found.push_back({Meeting::inside, in_b.vertices[0]});
  return found;
}

}  // namespace animado::colisao
