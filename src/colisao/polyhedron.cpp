#include "colisao/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/convex_hull.hpp"
#include "base/error.hpp"

namespace animado::colisao {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(
      Code::refused, what, "hull",
      "give a closed convex polyhedron whose faces are flat and counter-clockwise seen from outside, or only "
      "its vertices");
}

// Newell's normal: the area vector of a polygon, exact for a flat one whatever its corners.
Vec3 area_of(const std::vector<Vec3>& vertices, const std::vector<int>& corners) {
  Vec3 area = Vec3::Zero();
  const Vec3& first = vertices[static_cast<size_t>(corners[0])];
  for (size_t k = 1; k + 1 < corners.size(); ++k) {
    area += (vertices[static_cast<size_t>(corners[k])] - first)
                .cross(vertices[static_cast<size_t>(corners[k + 1])] - first);
  }
  return 0.5 * area;
}

Polyhedron::Face make_face(const std::vector<Vec3>& vertices, const std::vector<int>& corners,
                           double extent) {
  if (corners.size() < 3) refuse("a face has fewer than three vertices");
  for (int i : corners) {
    if (i < 0 || i >= static_cast<int>(vertices.size())) refuse("a face names a vertex that is not there");
  }
  const Vec3 area = area_of(vertices, corners);
  if (!(area.norm() > 1e-14 * extent * extent)) refuse("a face has no area");
  const Vec3 normal = area.normalized();
  double offset = 0;
  for (int i : corners)
    offset += normal.dot(vertices[static_cast<size_t>(i)]) / static_cast<double>(corners.size());
  return {corners, normal, offset};
}

std::vector<Polyhedron::Edge> join(const std::vector<Polyhedron::Face>& faces) {
  std::map<std::pair<int, int>, int> along;
  for (size_t f = 0; f < faces.size(); ++f) {
    const auto& corners = faces[f].vertices;
    for (size_t k = 0; k < corners.size(); ++k) {
      const std::pair edge{corners[k], corners[(k + 1) % corners.size()]};
      if (!along.emplace(edge, static_cast<int>(f)).second)
        refuse("two faces run along an edge in the same direction");
    }
  }
  std::vector<Polyhedron::Edge> edges;
  for (const auto& [edge, left] : along) {
    const auto back = along.find({edge.second, edge.first});
    if (back == along.end()) refuse("the surface is not closed");
    if (edge.first < edge.second) edges.push_back({edge.first, edge.second, left, back->second});
  }
  return edges;
}

void check_convex(const Polyhedron& p, double extent) {
  for (const Polyhedron::Face& face : p.faces) {
    for (const Vec3& v : p.vertices_m) {
      if (face.normal.dot(v) - face.offset_m > 1e-9 * extent) {
        refuse("a vertex lies outside a face: the solid is not convex, or the face looks inward");
      }
    }
    for (int i : face.vertices) {
      const double height = face.normal.dot(p.vertices_m[static_cast<size_t>(i)]) - face.offset_m;
      if (std::abs(height) > 1e-9 * extent) refuse("a face is not flat");
    }
  }
  if (p.vertices_m.size() + p.faces.size() != p.edges.size() + 2) {
    refuse("vertices, edges and faces do not make one closed surface");
  }
}

bool has_coplanar_faces(const Polyhedron& p) {
  return std::any_of(p.edges.begin(), p.edges.end(), [&](const Polyhedron::Edge& e) {
    return (p.faces[static_cast<size_t>(e.left)].normal - p.faces[static_cast<size_t>(e.right)].normal)
               .norm() < 1e-9;
  });
}

Polyhedron assemble(std::vector<Vec3> vertices, const std::vector<std::vector<int>>& faces) {
  double extent = 0;
  for (const Vec3& v : vertices) {
    if (!v.allFinite())
      throw Error(Code::not_finite, "a vertex is not finite", "hull", "give finite coordinates");
    extent = std::max(extent, (v - vertices[0]).norm());
  }
  Polyhedron p;
  p.vertices_m = std::move(vertices);
  for (const auto& corners : faces) p.faces.push_back(make_face(p.vertices_m, corners, extent));
  p.edges = join(p.faces);
  check_convex(p, extent);
  return p;
}

}  // namespace

Polyhedron make_polyhedron(const Box& box) {
  std::vector<Vec3> vertices;
  for (int i = 0; i < 8; ++i) {
    const Vec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    vertices.push_back(sign.cwiseProduct(box.half_m));
  }
  return assemble(std::move(vertices),
                  {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Polyhedron make_polyhedron(const Hull& hull) {
  if (hull.vertices_m.size() < 4 || hull.faces.size() < 4)
    refuse("a polyhedron has at least four vertices and faces");
  Polyhedron p = assemble(hull.vertices_m, hull.faces);
  if (!has_coplanar_faces(p)) return p;
  const Hull merged = convex_hull(hull.vertices_m);
  return assemble(merged.vertices_m, merged.faces);
}

Feature feature_of(const Polyhedron& p, const Vec3& direction, double tolerance_rad) {
  Feature feature;
  const auto take = [&](int vertex) {
    feature.points_m.push_back(p.vertices_m[static_cast<size_t>(vertex)]);
  };

  double nearest = tolerance_rad;
  for (const Polyhedron::Face& face : p.faces) {
    const double angle = (face.normal - direction).norm();
    if (angle > nearest) continue;
    nearest = angle;
    feature.id = static_cast<int>(&face - p.faces.data());
    feature.normal = face.normal;
  }
  if (!feature.normal.isZero(0)) {
    for (int v : p.faces[static_cast<size_t>(feature.id)].vertices) take(v);
    return feature;
  }

  int top = 0;
  for (size_t i = 1; i < p.vertices_m.size(); ++i) {
    if (direction.dot(p.vertices_m[i]) > direction.dot(p.vertices_m[static_cast<size_t>(top)]))
      top = static_cast<int>(i);
  }
  const Polyhedron::Edge* level = nullptr;
  for (const Polyhedron::Edge& edge : p.edges) {
    if (edge.from != top && edge.to != top) continue;
    const Vec3 along =
        p.vertices_m[static_cast<size_t>(edge.to)] - p.vertices_m[static_cast<size_t>(edge.from)];
    const double slope = std::abs(direction.dot(along)) / along.norm();
    if (slope > nearest) continue;
    nearest = slope;
    level = &edge;
  }
  if (level) {
    take(level->from);
    take(level->to);
    feature.id = static_cast<int>(p.faces.size() + static_cast<size_t>(level - p.edges.data()));
  } else {
    take(top);
    feature.id = static_cast<int>(p.faces.size() + p.edges.size()) + top;
  }
  return feature;
}

}  // namespace animado::colisao
