// The convex hull of a set of points, as a polyhedron whose coplanar triangles are merged into polygons.
#pragma once

#include <span>

#include "base/shape.hpp"

namespace animado {

// Points in metres, in any order, with repetitions. Points nearer to a face than 1e-10 of the extent count as
// lying in it and are left out unless they are corners. The vertices keep the order of the input. Error
// refused when the points are fewer than four, not finite, or in one plane.
Hull convex_hull(std::span<const Vec3> points_m);

}  // namespace animado
