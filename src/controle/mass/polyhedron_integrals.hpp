// ∫ 1, ∫ x and ∫ x xᵀ over the inside of a polyhedron, exactly.
#pragma once

#include "base/shape.hpp"

namespace animado::controle {

struct VolumeIntegrals {
  double volume_m3 = 0;                  // negative when the faces are clockwise seen from outside
  Vec3 centroid_m = Vec3::Zero();        // zero when the volume is
  Mat3 second_moment_m5 = Mat3::Zero();  // ∫ (x − centroid)(x − centroid)ᵀ
};

// The faces have to be planar, closed and oriented alike; convexity is not needed.
VolumeIntegrals integrate(const Hull& polyhedron);

}  // namespace animado::controle
