#include "controle/kinematics.hpp"

namespace animado::controle {
namespace {

// Angular velocity, world axes, of R = R_third · R_second · R_first about fixed axes: each angle's rate turns
// about its axis after the rotations that follow it.
Vec3 angular_velocity(const Vec3& angles_rad, const Vec3& rates_rad_s, const RotationOrder& order,
                      Quat& orientation) {
  Vec3 w = Vec3::Zero();
  Quat later = Quat::Identity();
  for (int k = 2; k >= 0; --k) {
    const int axis = order[static_cast<size_t>(k)];
    w += later * Vec3(rates_rad_s[axis] * Vec3::Unit(axis));
    later = later * Quat(Eigen::AngleAxisd(angles_rad[axis], Vec3::Unit(axis)));
  }
  orientation = later;
  return w;
}

BodyState along_expressions(const Path& path, const Moment& moment) {
  BodyState body = path.start;
  if (path.position) {
    body.pose.position_m = path.position->vector_with_rate(moment, body.velocity_m_s);
  }
  if (path.rotation) {
    Vec3 rates;
    const Vec3 angles = path.rotation->vector_with_rate(moment, rates);
    const Vec3 w = angular_velocity(angles, rates, path.rotation_order, body.pose.orientation);
    body.angular_velocity_body_rad_s = body.pose.orientation.conjugate() * w;
  }
  return body;
}

// Straight between rows, the shorter way round; at rest before the first and after the last.
BodyState along_script(const Path& path, double time_s) {
  BodyState body;
  const auto& rows = path.script;
  const auto after = std::upper_bound(rows.begin(), rows.end(), time_s,
                                      [](double t, const ScriptRow& row) { return t < row.time_s; });
  if (after == rows.begin() || after == rows.end()) {
    body.pose = after == rows.begin() ? rows.front().pose : rows.back().pose;
    return body;
  }
  const ScriptRow &from = *(after - 1), &to = *after;
  const double span_s = to.time_s - from.time_s, part = (time_s - from.time_s) / span_s;
  body.pose.position_m = from.pose.position_m + part * (to.pose.position_m - from.pose.position_m);
  body.pose.orientation = from.pose.orientation.slerp(part, to.pose.orientation);
  body.velocity_m_s = (to.pose.position_m - from.pose.position_m) / span_s;
  Quat turn = from.pose.orientation.conjugate() * to.pose.orientation;
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const Eigen::AngleAxisd whole(turn);
  body.angular_velocity_body_rad_s = whole.axis() * (whole.angle() / span_s);
  return body;
}

}  // namespace

void Kinematics::place(double* state, size_t bodies, double time_s) const {
  for (const Path& path : paths_) {
    const bool told = path.position || path.rotation;
    const BodyState body =
        told ? along_expressions(path, {state, bodies, time_s}) : along_script(path, time_s);
    store_body(state, bodies, path.body, body);
  }
}

void Kinematics::hold(double* rates, size_t bodies) const {
  for (const Path& path : paths_) {
    for (size_t row = 0; row < kStateRows; ++row) rates[row * bodies + path.body] = 0;
  }
}

}  // namespace animado::controle
