// The features of the curved shapes.
#pragma once

#include "base/shape.hpp"
#include "colisao/feature.hpp"

namespace animado::colisao {

// The point of a circle about the y axis, at y = 0, that is farthest along a direction; its centre when the
// direction is the axis.
inline Vec3 rim_point(double radius_m, const Vec3& direction) {
  const double radial = std::hypot(direction.x(), direction.z());
  if (radial == 0) return Vec3::Zero();
  return {radius_m / radial * direction.x(), 0, radius_m / radial * direction.z()};
}

// The feature of a sphere, capsule, cylinder or cone that faces a unit direction within an angle (body
// frame).
Feature curved_feature(const Shape& shape, const Vec3& direction, double tolerance_rad);

}  // namespace animado::colisao
