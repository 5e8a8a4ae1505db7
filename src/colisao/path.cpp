// With s = t / h in 0 … 1 and control points P0 … P3 = x0, x0 + h x0'/3, x1 − h x1'/3, x1, the interpolant is
//   x(s) = (1−s)³ P0 + 3 (1−s)² s P1 + 3 (1−s) s² P2 + s³ P3,
// and its derivatives are Bézier curves of the differences of the control points: each is bounded by the
// longest of them. For the quaternion Q(s), with q = Q/|Q|: ω = 2 Im(Q* Q')/|Q|², so |ω| ≤ 2|Q'|/|Q| and |ω'|
// ≤ 2|Q''|/|Q| + |ω|·2|Q'|/|Q|; |Q| is at least the smallest component of a control point along the mean of
// the two quaternions.
#include "colisao/path.hpp"

#include <algorithm>

namespace animado::colisao {
namespace {

// Only for ends that contradict their angular velocities: the bounds are then large, and still finite.
constexpr double kLeastNorm = 0.05;

template <class V>
void place(V (&control)[4], const V& from, const V& from_rate, const V& to, const V& to_rate, double step) {
  control[0] = from;
  control[1] = from + step / 3 * from_rate;
  control[2] = to - step / 3 * to_rate;
  control[3] = to;
}

template <class V>
V at(const V (&c)[4], double s) {
  const double r = 1 - s;
  return r * r * r * c[0] + 3 * r * r * s * c[1] + 3 * r * s * s * c[2] + s * s * s * c[3];
}

template <class V>
V rate_at(const V (&c)[4], double s, double step) {
  const double r = 1 - s;
  return 3 / step * (r * r * (c[1] - c[0]) + 2 * r * s * (c[2] - c[1]) + s * s * (c[3] - c[2]));
}

template <class V>
double most_rate(const V (&c)[4], double step) {
  return 3 / step * std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[3] - c[2]).norm()});
}

template <class V>
double most_second_rate(const V (&c)[4], double step) {
  return 6 / (step * step) * std::max((c[2] - 2 * c[1] + c[0]).norm(), (c[3] - 2 * c[2] + c[1]).norm());
}

Eigen::Vector4d rate_of(const BodyState& b) {
  const Vec3& w = b.angular_velocity_body_rad_s;
  return 0.5 * (b.pose.orientation * Quat(0, w.x(), w.y(), w.z())).coeffs();
}

}  // namespace

Path::Path(const BodyState& from, const BodyState& to, double step_s) : step_s_(step_s) {
  place(position_, from.pose.position_m, from.velocity_m_s, to.pose.position_m, to.velocity_m_s, step_s);
  Quat4 end = to.pose.orientation.coeffs(), end_rate = rate_of(to);
  if (end.dot(from.pose.orientation.coeffs()) < 0) {
    end = -end;
    end_rate = -end_rate;
  }
  place(quaternion_, from.pose.orientation.coeffs(), rate_of(from), end, end_rate, step_s);

  speed_m_s_ = most_rate(position_, step_s);
  acceleration_m_s2_ = most_second_rate(position_, step_s);
  const Quat4 middle = (quaternion_[0] + quaternion_[3]).normalized();
  double least = 1;
  for (const Quat4& q : quaternion_) least = std::min(least, q.dot(middle));
  least = std::max(least, kLeastNorm);
  const double rate = 2 * most_rate(quaternion_, step_s) / least;
  angular_speed_rad_s_ = rate;
  angular_acceleration_rad_s2_ = 2 * most_second_rate(quaternion_, step_s) / least + rate * rate;
}

Pose Path::pose(double time_s) const {
  const double s = time_s / step_s_;
  return {at(position_, s), Quat(at(quaternion_, s).normalized())};
}

BodyState Path::state(double time_s) const {
  const double s = time_s / step_s_;
  const Quat4 q = at(quaternion_, s);
  const Quat spin = Quat(q).conjugate() * Quat(rate_at(quaternion_, s, step_s_));
  return {{at(position_, s), Quat(q.normalized())},
          rate_at(position_, s, step_s_),
          2 / q.squaredNorm() * spin.vec()};
}

}  // namespace animado::colisao
