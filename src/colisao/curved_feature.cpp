#include "colisao/curved_feature.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace animado::colisao {
namespace {

Feature point_feature(const Vec3& point, bool sharp, int id) {
  Feature f;
  f.points_m.push_back(point);
  f.sharp = sharp;
  f.id = id;
  return f;
}

Feature line_feature(const Vec3& from, const Vec3& to, int id) {
  Feature f;
  f.points_m.push_back(from);
  f.points_m.push_back(to);
  f.sharp = false;
  f.id = id;
  return f;
}

// A disc across the y axis that looks up or down, with eight points of its rim at fixed places of the body.
Feature disc_feature(double radius, double y, bool up, int id) {
  Feature f;
  for (int k = 0; k < 8; ++k) {
    const double angle = (up ? -k : k) * std::numbers::pi / 4;
    f.points_m.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
  }
  f.normal = up ? Vec3::UnitY() : Vec3(-Vec3::UnitY());
  f.disc = true;
  f.centre_m = {0, y, 0};
  f.radius_m = radius;
  f.id = id;
  return f;
}

Feature feature_of(const Sphere& s, const Vec3& d, double) {
  return point_feature(s.radius_m * d, false, 0);
}

Feature feature_of(const Capsule& c, const Vec3& d, double tolerance) {
  const Vec3 end(0, c.half_height_m, 0), offset = c.radius_m * d;
  if (std::abs(d.y()) <= tolerance) return line_feature(offset - end, offset + end, 0);
  return point_feature(d.y() > 0 ? Vec3(offset + end) : Vec3(offset - end), false, d.y() > 0 ? 1 : 2);
}

Feature feature_of(const Cylinder& c, const Vec3& d, double tolerance) {
  const bool up = d.y() > 0;
  const double y = up ? c.half_height_m : -c.half_height_m;
  if (std::hypot(d.x(), d.z()) <= tolerance) return disc_feature(c.radius_m, y, up, up ? 0 : 1);
  const Vec3 rim = rim_point(c.radius_m, d), half(0, c.half_height_m, 0);
  if (std::abs(d.y()) <= tolerance) return line_feature(rim - half, rim + half, 2);
  return point_feature(rim + Vec3(0, y, 0), true, up ? 3 : 4);
}

Feature feature_of(const Cone& c, const Vec3& d, double tolerance) {
  const double radial = std::hypot(d.x(), d.z());
  const Vec3 apex(0, 0.75 * c.height_m, 0), base(0, -0.25 * c.height_m, 0);
  if (radial <= tolerance && d.y() < 0) return disc_feature(c.radius_m, base.y(), false, 0);
  const Vec3 rim = base + rim_point(c.radius_m, d);
  const double above_slope = std::atan2(d.y(), radial) - std::atan2(c.radius_m, c.height_m);
  if (std::abs(above_slope) <= tolerance) return line_feature(rim, apex, 1);
  return above_slope > 0 ? point_feature(apex, true, 2) : point_feature(rim, true, 3);
}

template <class Other>
Feature feature_of(const Other&, const Vec3&, double) {
  assert(!"not a curved shape");
  return {};
}

}  // namespace

Feature curved_feature(const Shape& shape, const Vec3& direction, double tolerance_rad) {
  return std::visit([&](const auto& s) { return feature_of(s, direction, tolerance_rad); }, shape);
}

}  // namespace animado::colisao
