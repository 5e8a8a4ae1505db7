#include "colisao/flight.hpp"

#include <cmath>

namespace animado::colisao {

namespace {

Quat turn(const Vec3& rotation_rad) {
  const double angle = rotation_rad.norm();
  return angle == 0 ? Quat::Identity() : Quat(Eigen::AngleAxisd(angle, rotation_rad / angle));
}

// From one state to the other at the mean velocity. The velocities at the ends may be those of a path that
// stops in between, and a cubic through both would be faster on the way than either.
Path steady(BodyState start, BodyState end, double step_s) {
  start.velocity_m_s = end.velocity_m_s = (end.pose.position_m - start.pose.position_m) / step_s;
  Quat turned = start.pose.orientation.conjugate() * end.pose.orientation;
  if (turned.w() < 0) turned.coeffs() = -turned.coeffs();
  const Eigen::AngleAxisd whole(turned);
  start.angular_velocity_body_rad_s = whole.angle() / step_s * whole.axis();
  end.angular_velocity_body_rad_s = start.angular_velocity_body_rad_s;
  return {start, end, step_s};
}

}  // namespace

Flight::Flight(const Body& body, const BodyState& start, const Vec3& acceleration_m_s2,
               const Vec3& angular_body_rad_s2)
    : body_(body), state_(start), now_(moving(body, start)) {
  const Vec3& spin = start.angular_velocity_body_rad_s;
  const Vec3& c = body.center_of_mass_m;
  const Quat& q = start.pose.orientation;
  acceleration_ = acceleration_m_s2 + q * (angular_body_rad_s2.cross(c) + spin.cross(spin.cross(c)));
  torque_ = q * (body.inertia_kg_m2 * angular_body_rad_s2 + spin.cross(body.inertia_kg_m2 * spin));
}

Flight::Flight(const Body& body, const BodyState& start, const BodyState& end, double step_s)
    : body_(body), state_(start), now_(moving(body, start)) {
  if (body.motion != Motion::kinematic) return;
  path_.emplace(steady(start, end, step_s));
  now_ = moving(body_, path_->state(0));
}

// The angular momentum is carried, by the midpoint rule for the orientation, so that a torque-free body keeps
// it exactly.
Moving Flight::ahead(const Moving& from, double substep_s) const {
  Moving m = from;
  if (path_) return moving(body_, path_->state(time_s_ + substep_s));
  if (!body_.is_dynamic()) return m;
  const Quat& q = state_.pose.orientation;
  const Vec3 momentum = q * (body_.inertia_kg_m2 * (q.conjugate() * from.spin_rad_s));
  const auto spin = [&](const Quat& at, const Vec3& L) -> Vec3 {
    return at * (body_.inverse_inertia_1_kg_m2 * (at.conjugate() * L));
  };
  const Quat middle = turn(substep_s / 2 * from.spin_rad_s) * q;
  const Quat end = (turn(substep_s * spin(middle, momentum + substep_s / 2 * torque_)) * q).normalized();
  const Mat3 rotation = end.toRotationMatrix();
  m.velocity_m_s += substep_s * acceleration_;
  m.spin_rad_s = spin(end, momentum + substep_s * torque_);
  m.inverse_inertia_1_kg_m2 = rotation * body_.inverse_inertia_1_kg_m2 * rotation.transpose();
  return m;
}

void Flight::travel(const Moving& from, const Moving& to, double substep_s) {
  time_s_ += substep_s;
  if (path_) {
    state_ = path_->state(time_s_);
    now_ = moving(body_, state_);
    return;
  }
  if (!body_.is_dynamic()) return;
  const Quat end = turn(substep_s / 2 * (from.spin_rad_s + to.spin_rad_s)) * state_.pose.orientation;
  place(now_.center_m + substep_s / 2 * (from.velocity_m_s + to.velocity_m_s), end.normalized());
  // The orientation is not quite that which `to` was made for: the angular momentum is kept, not the spin.
  const Mat3 inertia = to.inverse_inertia_1_kg_m2.inverse();
  const Quat& q = state_.pose.orientation;
  now_.velocity_m_s = to.velocity_m_s;
  now_.spin_rad_s = q * (body_.inverse_inertia_1_kg_m2 * (q.conjugate() * (inertia * to.spin_rad_s)));
  set_velocities(body_, now_, state_);
}

double Flight::shift(const Vec3& displacement_m, const Vec3& rotation_rad) {
  place(now_.center_m + displacement_m, (turn(rotation_rad) * state_.pose.orientation).normalized());
  set_velocities(body_, now_, state_);
  return body_.mass_kg * acceleration_.dot(displacement_m) + torque_.dot(rotation_rad);
}

void Flight::place(const Vec3& center_m, const Quat& orientation) {
  state_.pose.orientation = orientation;
  state_.pose.position_m = center_m - orientation * body_.center_of_mass_m;
  now_.center_m = center_m;
  const Mat3 rotation = orientation.toRotationMatrix();
  now_.inverse_inertia_1_kg_m2 = rotation * body_.inverse_inertia_1_kg_m2 * rotation.transpose();
}

}  // namespace animado::colisao
