// Euler angles about fixed axes, in any order of x, y and z (the paper, section 3.1; x, y, z there: R =
// Rz·Ry·Rx).
#pragma once

#include "controle/scene/scene.hpp"

namespace animado::controle {

// angles_rad: about x, y and z, whatever the order in which they are applied.
Quat orientation_of(const Vec3& angles_rad, const RotationOrder& order);

// The angles that give the orientation: the second of the order in [−π/2, π/2], the others in (−π, π]. Where
// the second is ±π/2 only a sum of the others is known: the third of the order is 0.
Vec3 angles_of(const Quat& orientation, const RotationOrder& order);

}  // namespace animado::controle
