#include "colisao/solid.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "colisao/curved_feature.hpp"

namespace animado::colisao {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_length(double length_m, const char* where) {
  if (!std::isfinite(length_m))
    throw Error(Code::not_finite, "a length is not finite", where, "give a finite length");
  if (!(length_m > 0)) throw Error(Code::refused, "a length is not positive", where, "give a length above 0");
}

struct Sizes {
  double core_radius_m, radius_m, size_m;
};

Sizes sizes_of(const Sphere& s, const Polyhedron*) {
  check_length(s.radius_m, "sphere");
  return {s.radius_m, s.radius_m, s.radius_m};
}
Sizes sizes_of(const Box& b, const Polyhedron*) {
  return {0, b.half_m.norm(), b.half_m.minCoeff()};
}
Sizes sizes_of(const Capsule& c, const Polyhedron*) {
  check_length(c.radius_m, "capsule");
  check_length(c.half_height_m, "capsule");
  return {c.radius_m, c.radius_m + c.half_height_m, c.radius_m};
}
Sizes sizes_of(const Cylinder& c, const Polyhedron*) {
  check_length(c.radius_m, "cylinder");
  check_length(c.half_height_m, "cylinder");
  return {0, std::hypot(c.radius_m, c.half_height_m), std::min(c.radius_m, c.half_height_m)};
}
Sizes sizes_of(const Cone& c, const Polyhedron*) {
  check_length(c.radius_m, "cone");
  check_length(c.height_m, "cone");
  return {0, std::max(0.75 * c.height_m, std::hypot(c.radius_m, 0.25 * c.height_m)),
          std::min(c.radius_m, 0.5 * c.height_m)};
}
Sizes sizes_of(const Hull&, const Polyhedron* p) {
  double radius = 0, width = kInfinity;
  for (const Vec3& v : p->vertices_m) radius = std::max(radius, v.norm());
  for (const Polyhedron::Face& face : p->faces) {
    double lowest = kInfinity;
    for (const Vec3& v : p->vertices_m) lowest = std::min(lowest, face.normal.dot(v));
    width = std::min(width, face.offset_m - lowest);
  }
  return {0, radius, 0.5 * width};
}
Sizes sizes_of(const HalfSpace& h, const Polyhedron*) {
  if (!h.normal.allFinite() || !std::isfinite(h.offset_m)) {
    throw Error(Code::not_finite, "a plane is not finite", "plane", "give a finite normal and offset");
  }
  if (std::abs(h.normal.norm() - 1) > 1e-9) {
    throw Error(Code::refused, "the normal of a plane is not a unit vector", "plane",
                "divide it by its length");
  }
  return {0, kInfinity, kInfinity};
}

Vec3 support_of(const Sphere&, const Polyhedron*, const Vec3&) {
  return Vec3::Zero();
}
Vec3 support_of(const Box& b, const Polyhedron*, const Vec3& d) {
  return {std::copysign(b.half_m.x(), d.x()), std::copysign(b.half_m.y(), d.y()),
          std::copysign(b.half_m.z(), d.z())};
}
Vec3 support_of(const Capsule& c, const Polyhedron*, const Vec3& d) {
  return {0, std::copysign(c.half_height_m, d.y()), 0};
}
Vec3 support_of(const Cylinder& c, const Polyhedron*, const Vec3& d) {
  Vec3 p = rim_point(c.radius_m, d);
  p.y() = std::copysign(c.half_height_m, d.y());
  return p;
}
Vec3 support_of(const Cone& c, const Polyhedron*, const Vec3& d) {
  // The apex is farther along d than the rim when d rises more steeply than the normal of the slope.
  const double radial = std::hypot(d.x(), d.z());
  if (d.y() * c.height_m > radial * c.radius_m) return {0, 0.75 * c.height_m, 0};
  Vec3 p = rim_point(c.radius_m, d);
  p.y() = -0.25 * c.height_m;
  return p;
}
Vec3 support_of(const Hull&, const Polyhedron* p, const Vec3& d) {
  size_t best = 0;
  double most = d.dot(p->vertices_m[0]);
  for (size_t i = 1; i < p->vertices_m.size(); ++i) {
    const double reach = d.dot(p->vertices_m[i]);
    if (reach > most) {
      most = reach;
      best = i;
    }
  }
  return p->vertices_m[best];
}
Vec3 support_of(const HalfSpace&, const Polyhedron*, const Vec3&) {
  assert(!"a half-space has no farthest point");
  return Vec3::Zero();
}

}  // namespace

Solid::Solid(Shape shape) : shape_(std::move(shape)) {
  if (const auto* box = std::get_if<Box>(&shape_)) {
    for (int k = 0; k < 3; ++k) check_length(box->half_m[k], "box");
    polyhedron_ = std::make_shared<Polyhedron>(make_polyhedron(*box));
  } else if (const auto* hull = std::get_if<Hull>(&shape_)) {
    polyhedron_ = std::make_shared<Polyhedron>(make_polyhedron(*hull));
  }
  const Sizes b = std::visit([&](const auto& s) { return sizes_of(s, polyhedron_.get()); }, shape_);
  core_radius_m_ = b.core_radius_m;
  radius_m_ = b.radius_m;
  size_m_ = b.size_m;
}

Vec3 Solid::core_support(const Vec3& direction) const {
  return std::visit([&](const auto& s) { return support_of(s, polyhedron_.get(), direction); }, shape_);
}

Vec3 Solid::support(const Vec3& direction) const {
  if (core_radius_m_ == 0) return core_support(direction);
  return core_support(direction) + core_radius_m_ * direction.normalized();
}

Feature Solid::feature(const Vec3& direction, double tolerance_rad) const {
  if (polyhedron_) return feature_of(*polyhedron_, direction, tolerance_rad);
  return curved_feature(shape_, direction, tolerance_rad);
}

}  // namespace animado::colisao
