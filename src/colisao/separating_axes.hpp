// The best separating axis of two convex polyhedra: the unit normal n, from b to a, with the largest
//   s(n) = min over A of n · x − max over B of n · x.
// The largest s is the distance when a face is part of the nearest features, and minus the depth when they
// overlap. It is reached at a face normal of either or at the cross product of two edges whose arcs cross on
// the Gauss map (Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996; the pruning of edges by Gregorius, GDC
// 2013). Of equal axes a face wins against edges, b against a, the first against the later.
#pragma once

#include "colisao/placed.hpp"

namespace animado::colisao {

struct Axis {
  Vec3 normal = Vec3::Zero();  // world
  double separation_m = 0;
};

// Both solids must be polyhedra.
Axis separating_axis(const Placed& a, const Placed& b);

}  // namespace animado::colisao
