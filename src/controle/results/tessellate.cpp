#include "controle/results/tessellate.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace animado::controle {
namespace {

constexpr uint32_t kSlices = 48;  // around the axis
constexpr int kArcSegments = 12;  // in a quarter of a meridian
constexpr double kPi = std::numbers::pi;

// A point of a meridian in the half-plane through the axis y: distance from the axis, height, and the normal
// there.
struct ProfilePoint {
  double radius_m, y_m, normal_radial, normal_y;
};
using Profile = std::vector<ProfilePoint>;

void append(TriangleMesh& mesh, const Vec3& position_m, const Vec3& normal) {
  mesh.positions_m.push_back(position_m);
  mesh.normals.push_back(normal);
}

void append(TriangleMesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

uint32_t size(const TriangleMesh& mesh) {
  return static_cast<uint32_t>(mesh.positions_m.size());
}

// Turns a profile, listed from bottom to top, about y. Triangles of a ring that has shrunk to a point are
// left out.
void revolve(TriangleMesh& mesh, const Profile& profile) {
  const uint32_t first = size(mesh);
  for (const ProfilePoint& p : profile) {
    for (uint32_t slice = 0; slice < kSlices; ++slice) {
      const double angle = 2 * kPi * slice / kSlices, c = std::cos(angle), s = std::sin(angle);
      append(mesh, {p.radius_m * c, p.y_m, p.radius_m * s},
             {p.normal_radial * c, p.normal_y, p.normal_radial * s});
    }
  }
  for (uint32_t k = 0; k + 1 < profile.size(); ++k) {
    const uint32_t low = first + k * kSlices, high = low + kSlices;
    for (uint32_t slice = 0; slice < kSlices; ++slice) {
      const uint32_t next = (slice + 1) % kSlices;
      if (profile[k].radius_m > 0) append(mesh, low + slice, high + slice, low + next);
      if (profile[k + 1].radius_m > 0) append(mesh, low + next, high + slice, high + next);
    }
  }
}

// A quarter of a circle around (0, center_y_m), from angle −π/2 + quarter·π/2 upwards; its ends are exact.
void append_arc(Profile& profile, double radius_m, double center_y_m, int quarter) {
  for (int k = 0; k <= kArcSegments; ++k) {
    const double angle = kPi / 2 * (quarter - 1 + static_cast<double>(k) / kArcSegments);
    const bool pole = (quarter == 0 && k == 0) || (quarter == 1 && k == kArcSegments);
    const double c = pole ? 0 : std::cos(angle), s = std::sin(angle);
    profile.push_back({radius_m * c, center_y_m + radius_m * s, c, s});
  }
}

// A flat polygon, corners counter-clockwise seen from where the normal points.
void append_polygon(TriangleMesh& mesh, const std::vector<Vec3>& corners_m, const Vec3& normal) {
  const uint32_t first = size(mesh);
  for (const Vec3& corner : corners_m) append(mesh, corner, normal);
  for (uint32_t k = 2; k < corners_m.size(); ++k) append(mesh, first, first + k - 1, first + k);
}

struct Tessellator {
  double plane_extent_m;

  TriangleMesh operator()(const Sphere& s) const { return (*this)(Capsule{s.radius_m, 0}); }

  TriangleMesh operator()(const Capsule& c) const {
    Profile profile;
    append_arc(profile, c.radius_m, -c.half_height_m, 0);
    if (c.half_height_m == 0) profile.pop_back();  // the equator is the other arc's too
    append_arc(profile, c.radius_m, c.half_height_m, 1);
    TriangleMesh mesh;
    revolve(mesh, profile);
    return mesh;
  }

  TriangleMesh operator()(const Cylinder& c) const {
    const double r = c.radius_m, h = c.half_height_m;
    TriangleMesh mesh;
    revolve(mesh, {{0, -h, 0, -1}, {r, -h, 0, -1}});
    revolve(mesh, {{r, -h, 1, 0}, {r, h, 1, 0}});
    revolve(mesh, {{r, h, 0, 1}, {0, h, 0, 1}});
    return mesh;
  }

  TriangleMesh operator()(const Cone& c) const {
    const double r = c.radius_m, base_m = -c.height_m / 4, apex_m = 3 * c.height_m / 4;
    const double slant = std::hypot(r, c.height_m), radial = c.height_m / slant, up = r / slant;
    TriangleMesh mesh;
    revolve(mesh, {{0, base_m, 0, -1}, {r, base_m, 0, -1}});
    revolve(mesh, {{r, base_m, radial, up}, {0, apex_m, radial, up}});
    return mesh;
  }

  TriangleMesh operator()(const Box& b) const {
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const Vec3 u = Vec3::Unit((axis + 1) % 3) * b.half_m[(axis + 1) % 3] * side;
        const Vec3 v = Vec3::Unit((axis + 2) % 3) * b.half_m[(axis + 2) % 3];
        const Vec3 center = Vec3::Unit(axis) * b.half_m[axis] * side;
        append_polygon(mesh, {center - u - v, center + u - v, center + u + v, center - u + v},
                       Vec3::Unit(axis) * side);
      }
    }
    return mesh;
  }

  TriangleMesh operator()(const Hull& h) const {
    TriangleMesh mesh;
    for (const std::vector<int>& face : h.faces) {
      std::vector<Vec3> corners;
      for (const int vertex : face) corners.push_back(h.vertices_m[static_cast<size_t>(vertex)]);
      Vec3 area = Vec3::Zero();  // Newell: right for corners that lie in a line, too
      for (size_t k = 0; k < corners.size(); ++k) area += corners[k].cross(corners[(k + 1) % corners.size()]);
      append_polygon(mesh, corners, area.normalized());
    }
    return mesh;
  }

  TriangleMesh operator()(const HalfSpace& p) const {
    const Vec3 u = p.normal.unitOrthogonal() * plane_extent_m, v = p.normal.cross(u),
               center = p.normal * p.offset_m;
    TriangleMesh mesh;
    append_polygon(mesh, {center - u - v, center + u - v, center + u + v, center - u + v}, p.normal);
    return mesh;
  }
};

}  // namespace

TriangleMesh tessellate(const Shape& shape, double plane_extent_m) {
  return std::visit(Tessellator{plane_extent_m}, shape);
}

}  // namespace animado::controle
