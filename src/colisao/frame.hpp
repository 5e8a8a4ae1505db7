// The paper's collision frame i, j, k (figure 4): k perpendicular to the collision plane, i and j in it.
#pragma once

#include "base/spatial.hpp"

namespace animado::colisao {

// Rows k, i, j: turns world vectors into (normal, tangential, tangential). i is perpendicular to the world
// axis least along k.
inline Mat3 collision_frame(const Vec3& k) {
  int least = 0;
  k.cwiseAbs().minCoeff(&least);
  const Vec3 i = Vec3::Unit(least).cross(k).normalized();
  Mat3 frame;
  frame << k.transpose(), i.transpose(), k.cross(i).transpose();
  return frame;
}

}  // namespace animado::colisao
