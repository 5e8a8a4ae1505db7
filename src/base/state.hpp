// How the state of N bodies lies in memory: 13 rows of N numbers ("lanes"), so that one operation serves many
// bodies.
#pragma once

#include <cstddef>

#include "base/spatial.hpp"

namespace animado {

// Rows of the state array, shape (13, N):
//   p  origin of the body frame, world, m
//   q  orientation, body → world, unit quaternion
//   v  velocity of the origin of the body frame, world, m/s
//   w  angular velocity, in BODY axes, rad/s: equation (1) of the paper is written there
enum StateRow : int { kPx, kPy, kPz, kQw, kQx, kQy, kQz, kVx, kVy, kVz, kWx, kWy, kWz, kStateRows };

// One body's view of a state array.
struct BodyState {
  Pose pose;
  Vec3 velocity_m_s = Vec3::Zero();  // of the origin of the body frame, world
  Vec3 angular_velocity_body_rad_s = Vec3::Zero();

  Vec3 angular_velocity_rad_s() const { return pose.orientation * angular_velocity_body_rad_s; }  // world
};

inline BodyState load_body(const double* state, size_t bodies, size_t i) {
  const auto at = [&](int row) { return state[static_cast<size_t>(row) * bodies + i]; };
  BodyState b;
  b.pose.position_m = {at(kPx), at(kPy), at(kPz)};
  b.pose.orientation = Quat(at(kQw), at(kQx), at(kQy), at(kQz));
  b.velocity_m_s = {at(kVx), at(kVy), at(kVz)};
  b.angular_velocity_body_rad_s = {at(kWx), at(kWy), at(kWz)};
  return b;
}

inline void store_body(double* state, size_t bodies, size_t i, const BodyState& b) {
  const auto put = [&](int row, double value) { state[static_cast<size_t>(row) * bodies + i] = value; };
  for (int k = 0; k < 3; ++k) {
    put(kPx + k, b.pose.position_m[k]);
    put(kVx + k, b.velocity_m_s[k]);
    put(kWx + k, b.angular_velocity_body_rad_s[k]);
  }
  put(kQw, b.pose.orientation.w());
  put(kQx, b.pose.orientation.x());
  put(kQy, b.pose.orientation.y());
  put(kQz, b.pose.orientation.z());
}

}  // namespace animado
