// A convex polyhedron prepared for collision: the faces with their planes, the edges with the faces that they
// join.
#pragma once

#include <vector>

#include "base/shape.hpp"
#include "colisao/feature.hpp"

namespace animado::colisao {

struct Polyhedron {
  struct Face {
    std::vector<int> vertices;  // counter-clockwise seen from outside
    Vec3 normal;                // unit, outward
    double offset_m;            // normal · x = offset in the face
  };
  struct Edge {
    int from, to;     // vertices
    int left, right;  // faces: `left` runs along the edge from `from` to `to`, `right` against it
  };

  std::vector<Vec3> vertices_m;
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

// Error refused, with a remedy, when a face is not planar or not convex, the surface is not closed, the faces
// do not look outward, or the solid is not convex. Planarity and convexity to 1e-9 of the extent.
Polyhedron make_polyhedron(const Box& box);
Polyhedron make_polyhedron(const Hull& hull);

// The face, edge or vertex that faces a unit direction within an angle.
Feature feature_of(const Polyhedron& polyhedron, const Vec3& direction, double tolerance_rad);

}  // namespace animado::colisao
