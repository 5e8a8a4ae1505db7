// A shape prepared for collision: its support function, the features of its surface, its bounds. Curved
// shapes stay exact.
//
// A solid is a core and a radius: every point of it is nearer than the radius to the core. A sphere is a
// point with a radius, a capsule a segment with a radius; the cores of the others are the shapes themselves,
// and their radius is 0.
#pragma once

#include <memory>

#include "base/shape.hpp"
#include "colisao/feature.hpp"
#include "colisao/polyhedron.hpp"

namespace animado::colisao {

class Solid {
 public:
  // Error refused when a length is not positive, a number not finite, or a hull not a closed convex
  // polyhedron.
  explicit Solid(Shape shape);

  const Shape& shape() const { return shape_; }
  // Null when the solid is curved or infinite.
  const Polyhedron* polyhedron() const { return polyhedron_.get(); }
  // Null unless the solid is a half-space.
  const HalfSpace* half_space() const { return std::get_if<HalfSpace>(&shape_); }

  double core_radius_m() const { return core_radius_m_; }
  // Of the smallest ball about the frame's origin that holds the solid; infinite for a half-space.
  double radius_m() const { return radius_m_; }
  // Half the smallest extent, the length that "small" is measured by; infinite for a half-space.
  double size_m() const { return size_m_; }

  // The point of the core farthest along a direction (body frame, any length but 0). Not for a half-space.
  Vec3 core_support(const Vec3& direction) const;
  // The same for the solid itself.
  Vec3 support(const Vec3& direction) const;
  // The feature that faces a unit direction, within an angle. Not for a half-space.
  Feature feature(const Vec3& direction, double tolerance_rad) const;

 private:
  Shape shape_;
  std::shared_ptr<const Polyhedron> polyhedron_;
  double core_radius_m_ = 0, radius_m_ = 0, size_m_ = 0;
};

}  // namespace animado::colisao
