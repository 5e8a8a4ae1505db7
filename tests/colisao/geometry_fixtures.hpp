// Solids and poses for the tests of the geometry.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "base/convex_hull.hpp"
#include "base/state.hpp"
#include "colisao/distance.hpp"
#include "colisao/solid.hpp"

namespace animado::colisao {

// A reproducible stream of numbers.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 33) / 2147483648.0;
  }
  Vec3 vector(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  Vec3 direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Quat rotation() {
    const double u = uniform(0, 1), v = uniform(0, 2 * std::numbers::pi),
                 w = uniform(0, 2 * std::numbers::pi);
    return {std::sqrt(u) * std::cos(w), std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v),
            std::sqrt(u) * std::sin(w)};
  }
  Pose pose(double half) {
    const Vec3 position = vector(half);
    return {position, rotation()};
  }

 private:
  uint64_t state_;
};

inline Hull some_hull() {
  Random random(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 16; ++i) points.push_back(Vec3(0.9, 0.6, 0.7).cwiseProduct(random.direction()));
  return convex_hull(points);
}

struct Named {
  std::string name;
  Solid solid;
};

// One of each kind, none of them symmetric in more than it must be.
inline std::vector<Named> one_of_each() {
  return {{"sphere", Solid(Sphere{0.7})},
          {"box", Solid(Box{{0.5, 0.8, 0.3}})},
          {"capsule", Solid(Capsule{0.3, 0.6})},
          {"cylinder", Solid(Cylinder{0.6, 0.4})},
          {"cone", Solid(Cone{0.7, 1.1})},
          {"hull", Solid(some_hull())},
          {"plane", Solid(HalfSpace{{0, 1, 0}, 0.2})}};
}

inline Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

inline BodyState moving_body(const Vec3& position, const Quat& orientation, const Vec3& velocity,
                             const Vec3& spin_world) {
  return {{position, orientation}, velocity, orientation.conjugate() * spin_world};
}

// The state of torque-free motion of a body whose moments are equal, after a time: exact.
inline BodyState after(const BodyState& start, double time_s) {
  BodyState s = start;
  s.pose.position_m += time_s * start.velocity_m_s;
  const Vec3 spin = start.angular_velocity_rad_s();
  if (spin.norm() > 0) s.pose.orientation = about(spin, spin.norm() * time_s) * start.pose.orientation;
  return s;
}

}  // namespace animado::colisao
