// How a body moves between two states, and how fast at most: the dense output on which impacts are found.
#pragma once

#include "base/state.hpp"

namespace animado::colisao {

// Cubic Hermite interpolant of the position and of the quaternion, q' = ½ q ω (ω in body axes), normalised.
// Fourth order in the step. The two quaternions may differ in sign.
class Path {
 public:
  Path(const BodyState& from, const BodyState& to, double step_s);

  Pose pose(double time_s) const;
  BodyState state(double time_s) const;  // the pose and its exact derivative

  // Bounds over the whole step: of the speed of the origin, of the angular velocity, and of their
  // derivatives.
  double speed_m_s() const { return speed_m_s_; }
  double angular_speed_rad_s() const { return angular_speed_rad_s_; }
  double acceleration_m_s2() const { return acceleration_m_s2_; }
  double angular_acceleration_rad_s2() const { return angular_acceleration_rad_s2_; }

 private:
  using Quat4 = Eigen::Vector4d;  // x, y, z, w

  double step_s_;
  Vec3 position_[4];  // Bézier control points: the curve stays within their hull
  Quat4 quaternion_[4];
  double speed_m_s_, angular_speed_rad_s_, acceleration_m_s2_, angular_acceleration_rad_s2_;
};

}  // namespace animado::colisao
