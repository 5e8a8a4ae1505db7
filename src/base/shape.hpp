// The solids a body can be. Curved ones are exact. Every primitive has its centroid at the origin of the body
// frame, and its axis, where it has one, along y. Lengths in metres.
#pragma once

#include <variant>
#include <vector>

#include "base/spatial.hpp"

namespace animado {

struct Sphere {
  double radius_m;
};
struct Box {  // a cube too
  Vec3 half_m;
};
struct Capsule {
  double radius_m, half_height_m;  // half the distance between the centres of its two caps
};
struct Cylinder {
  double radius_m, half_height_m;
};
struct Cone {  // base at y = −height/4, apex at y = +3 height/4
  double radius_m, height_m;
};
struct Hull {  // convex polyhedron
  std::vector<Vec3> vertices_m;
  std::vector<std::vector<int>> faces;  // planar polygons, counter-clockwise seen from outside
};
struct HalfSpace {  // normal · x ≤ offset is solid; infinite, for static bodies only
  Vec3 normal;      // unit
  double offset_m;
};

using Shape = std::variant<Sphere, Box, Capsule, Cylinder, Cone, Hull, HalfSpace>;

enum class Motion { dynamic, fixed, kinematic };  // "static", "path"/"script" in the scene

}  // namespace animado
