#include "base/euler.hpp"

#include <cmath>

namespace animado {

Quat orientation_of(const Vec3& angles_rad, const RotationOrder& order) {
  Quat q = Quat::Identity();
  for (const int axis : order) q = Quat(Eigen::AngleAxisd(angles_rad[axis], Vec3::Unit(axis))) * q;
  return q.normalized();
}

// With the order i, j, k, angles α, β, γ and e = ±1 as (i, j, k) is an even or odd permutation, R =
// Rk(γ)·Rj(β)·Ri(α) has
//   R(k,i) = −e sin β,   R(k,j) = e cos β sin α,   R(k,k) = cos β cos α,
// which gives α and β. γ then comes from the second column of R·Ri(−α) = Rk(γ)·Rj(β), whose length is 1 for
// any β; taken from R(j,i) and R(i,i), it would lose its digits next to the lock.
Vec3 angles_of(const Quat& orientation, const RotationOrder& order) {
  constexpr double kLockedCosine = 1e-15;  // what is left of cos(π/2) after a few roundings
  const auto [i, j, k] = order;
  const double e = (j - i + 3) % 3 == 1 ? 1 : -1;
  const Mat3 r = orientation.toRotationMatrix();
  const double cosine = std::hypot(r(k, j), r(k, k));

  Vec3 angles_rad;
  angles_rad[i] = cosine < kLockedCosine ? 0 : std::atan2(e * r(k, j), r(k, k));
  angles_rad[j] = std::atan2(-e * r(k, i), cosine);
  const double c = std::cos(angles_rad[i]), s = e * std::sin(angles_rad[i]);
  angles_rad[k] = std::atan2(e * (s * r(i, k) - c * r(i, j)), c * r(j, j) - s * r(j, k));
  return (angles_rad.array() + 0.0).matrix();  // −0 becomes 0
}

}  // namespace animado
