// The nearest points of cores of which one or both are solids of revolution, to rounding.
//
// A cylinder or cone is the union of its slices: the flat polygons between the axis and one meridian, at the
// angle θ. The distance of two slices is that of polyhedra, which GJK finds to rounding, and the distance of
// the solids is its minimum over the angles. There
//   ∂d/∂θ = n · ∂x/∂θ = 0,
// with x the nearest point on the slice and n the direction between the two: solved by Newton's method from a
// near guess.
#pragma once

#include "colisao/gjk.hpp"

namespace animado::colisao {

// `near` is a result of GJK for the same cores; returned as it is when neither is a cylinder or cone, or no
// slices are nearer.
CoreDistance refine_by_slices(const Placed& a, const Placed& b, const Vec3& shift, const CoreDistance& near);

}  // namespace animado::colisao
