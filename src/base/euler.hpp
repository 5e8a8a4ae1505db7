// Euler angles about the fixed axes of the world, in any of the six orders of x, y and z (Tait–Bryan). In the
// order x, y, z, the paper's (section 3.1) and the default of a scene, R = Rz·Ry·Rx.
#pragma once

#include <array>

#include "base/spatial.hpp"

namespace animado {

// The fixed axes (0 x, 1 y, 2 z) about which a body is turned, first one first; each once.
using RotationOrder = std::array<int, 3>;

// angles_rad: about x, y and z, whatever the order in which they are applied. Body → world.
Quat orientation_of(const Vec3& angles_rad, const RotationOrder& order);

// The angles that give a unit quaternion: the second of the order in [−π/2, π/2], the others in [−π, π].
// Where the second is ±π/2 (gimbal lock) only a sum or difference of the others is defined: the first of the
// order is then 0. orientation_of gives the same orientation back everywhere, also next to the lock.
Vec3 angles_of(const Quat& orientation, const RotationOrder& order);

}  // namespace animado
