// Solids as triangles, for pictures alone: the motion is computed with the exact shapes.
#pragma once

#include <cstdint>
#include <vector>

#include "base/shape.hpp"

namespace animado::controle {

struct TriangleMesh {
  std::vector<Vec3> positions_m,
      normals;                      // one normal a position: smooth on curved surfaces, doubled at edges
  std::vector<uint32_t> triangles;  // three a triangle, counter-clockwise seen from outside
};

// Body frame. A half-space becomes a square of side 2 plane_extent_m around the point of its plane nearest to
// the origin.
TriangleMesh tessellate(const Shape& shape, double plane_extent_m);

}  // namespace animado::controle
