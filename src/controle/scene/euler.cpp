#include "controle/scene/euler.hpp"

namespace animado::controle {

Quat orientation_of(const Vec3& angles_rad, const RotationOrder& order) {
  Quat q = Quat::Identity();
  for (const int axis : order) {
    q = Quat(Eigen::AngleAxisd(angles_rad[axis], Vec3::Unit(axis))) * q;
  }
  return q.normalized();
}

// With the order i, j, k and s = ±1 as (i, j, k) is an even or odd permutation, R = Rk·Rj·Ri has
//   R(k,i) = −s sin θj,   R(j,i) = s·sin θk cos θj,   R(i,i) = cos θk cos θj,
//   R(k,j) = s·sin θi cos θj,   R(k,k) = cos θi cos θj.
Vec3 angles_of(const Quat& orientation, const RotationOrder& order) {
  const auto [i, j, k] = order;
  const double s = (j - i + 3) % 3 == 1 ? 1 : -1;
  const Mat3 r = orientation.toRotationMatrix();
  const double cosine = std::hypot(r(i, i), r(j, i));

  Vec3 angles = Vec3::Zero();
  angles[j] = std::atan2(-s * r(k, i), cosine);
  // Below a few roundings of a rotation matrix's element the direction of (R(i,i), R(j,i)) is noise.
  if (cosine > 1e-12) {
    angles[i] = std::atan2(s * r(k, j), r(k, k));
    angles[k] = std::atan2(s * r(j, i), r(i, i));
  } else {
    angles[i] = std::atan2(-s * r(j, k), r(j, j));
  }
  return angles;
}

}  // namespace animado::controle
