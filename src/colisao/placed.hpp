// A solid in its pose, for the algorithms that ask it for supports in world axes. The origin may be moved
// near the pair, so that coordinates stay small and rounding with them.
#pragma once

#include "base/spatial.hpp"
#include "colisao/solid.hpp"

namespace animado::colisao {

struct Placed {
  const Solid& solid;
  Mat3 rotation;
  Vec3 position_m;

  Placed(const Solid& s, const Pose& pose, const Vec3& origin_m)
      : solid(s), rotation(pose.orientation.toRotationMatrix()), position_m(pose.position_m - origin_m) {}

  Vec3 core_support(const Vec3& direction) const {
    return position_m + rotation * solid.core_support(rotation.transpose() * direction);
  }
  Vec3 to_world(const Vec3& point_body) const { return position_m + rotation * point_body; }
};

}  // namespace animado::colisao
