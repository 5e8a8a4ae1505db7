// Vectors, rotations, poses. SI units; right-handed; quaternions are unit and turn body coordinates into
// world ones.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace animado {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

struct Pose {
  Vec3 position_m = Vec3::Zero();       // origin of the body frame, world
  Quat orientation = Quat::Identity();  // body → world

  Vec3 to_world(const Vec3& point_body) const { return position_m + orientation * point_body; }
  Vec3 to_body(const Vec3& point_world) const { return orientation.conjugate() * (point_world - position_m); }
};

// The matrix [v]× with [v]× u = v × u.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace animado
