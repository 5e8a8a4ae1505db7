// One body on its way through the sub-steps of an island, about its centre of mass.
//
// Between contacts the centre has a constant acceleration and the body a constant torque τ (world axes), both
// those of the start:
//
//   ẍ_c = a + ω̇×c + ω×(ω×c),   L̇ = τ = I ω̇ + ω×Iω                       (paper, equation 1, about the centre
//   of mass)
//
// with a, ω̇ the given accelerations and c the arm of the centre from the frame's origin. Velocities advance
// first; then the pose advances by the mean of the old and the new velocity, which is exact for a constant
// acceleration.
#pragma once

#include <optional>

#include "colisao/bodies.hpp"
#include "colisao/path.hpp"

namespace animado::colisao {

class Flight {
 public:
  // A dynamic body. acceleration: of the frame's origin (world); angular: body axes.
  Flight(const Body& body, const BodyState& start, const Vec3& acceleration_m_s2,
         const Vec3& angular_body_rad_s2);
  // A body that nothing pushes: a kinematic one moves between the two states, a fixed one stays.
  Flight(const Body& body, const BodyState& start, const BodyState& end, double step_s);

  Pose pose() const { return state_.pose; }
  const BodyState& state() const { return state_; }
  const Moving& now() const { return now_; }
  // Velocities at the end of a sub-step that starts with those of `from` and that nothing disturbs. The
  // centre stays, the inertia is that of the end.
  Moving ahead(const Moving& from, double substep_s) const;
  // Goes through a sub-step at whose start the velocities are those of `from` and at whose end those of `to`,
  // which came from ahead.
  void travel(const Moving& from, const Moving& to, double substep_s);
  // Moves the pose alone. Returns the work that the force and the torque would have done on the way, J.
  double shift(const Vec3& displacement_m, const Vec3& rotation_rad);

  // How much the speed of any point of the body may differ, within a time, from that of its centre now.
  double speed_about_center_m_s(double time_s) const {
    return now_.spin_rad_s.norm() * body_.radius_m + acceleration_.norm() * time_s;
  }

 private:
  void place(const Vec3& center_m, const Quat& orientation);

  Body body_;
  BodyState state_;
  Moving now_;
  Vec3 acceleration_ = Vec3::Zero(), torque_ = Vec3::Zero();
  std::optional<Path> path_;
  double time_s_ = 0;
};

// How fast the surfaces of two bodies may near each other within a time, as long as no contact acts.
inline double closing_bound_m_s(const Flight& a, const Flight& b, double time_s) {
  return (a.now().velocity_m_s - b.now().velocity_m_s).norm() + a.speed_about_center_m_s(time_s) +
         b.speed_about_center_m_s(time_s);
}

}  // namespace animado::colisao
