#include "colisao/bodies.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"

namespace animado::colisao {

Body dynamic_body(double mass_kg, const Mat3& inertia_kg_m2, const Vec3& center_of_mass_m) {
  if (!(mass_kg > 0)) {
    throw Error(Code::refused, "the mass of a dynamic body must be positive", "mass_kg",
                "give its mass in kilograms, or make it static");
  }
  const Eigen::LLT<Mat3> factor(inertia_kg_m2);
  if (factor.info() != Eigen::Success || !inertia_kg_m2.allFinite()) {
    throw Error(Code::refused, "the inertia tensor of a dynamic body must be positive definite",
                "inertia_kg_m2", "give the nine elements about the centre of mass in body axes");
  }
  Body body;
  body.mass_kg = mass_kg;
  body.center_of_mass_m = center_of_mass_m;
  body.inertia_kg_m2 = inertia_kg_m2;
  body.inverse_mass_1_kg = 1 / mass_kg;
  body.inverse_inertia_1_kg_m2 = factor.solve(Mat3::Identity());
  return body;
}

Body immovable_body(Motion motion) {
  assert(motion != Motion::dynamic);
  Body body;
  body.motion = motion;
  return body;
}

namespace {

double combined(RestitutionRule rule, double a, double b) {
  switch (rule) {
    case RestitutionRule::product:
      return a * b;
    case RestitutionRule::min:
      return std::min(a, b);
    case RestitutionRule::max:
      return std::max(a, b);
    case RestitutionRule::mean:
      return (a + b) / 2;
  }
  assert(false);
  return 0;
}

}  // namespace

Surface Bodies::surface(int i, int j) const {
  const Body& a = list[static_cast<size_t>(i)];
  const Body& b = list[static_cast<size_t>(j)];
  return {combined(rule, a.restitution, b.restitution), std::sqrt(a.friction * b.friction)};
}

Moving moving(const Body& body, const BodyState& state) {
  const Quat& q = state.pose.orientation;
  const Vec3 arm = q * body.center_of_mass_m;
  Moving m;
  m.center_m = state.pose.position_m + arm;
  m.spin_rad_s = state.angular_velocity_rad_s();
  m.velocity_m_s = state.velocity_m_s + m.spin_rad_s.cross(arm);
  m.inverse_mass_1_kg = body.inverse_mass_1_kg;
  if (body.is_dynamic()) {
    const Mat3 rotation = q.toRotationMatrix();
    m.inverse_inertia_1_kg_m2 = rotation * body.inverse_inertia_1_kg_m2 * rotation.transpose();
  }
  return m;
}

std::vector<Moving> moving(const Bodies& bodies, const std::vector<BodyState>& states) {
  assert(bodies.size() == states.size());
  std::vector<Moving> all;
  all.reserve(bodies.size());
  for (size_t i = 0; i < bodies.size(); ++i) all.push_back(moving(bodies[i], states[i]));
  return all;
}

void set_velocities(const Body& body, const Moving& moved, BodyState& state) {
  const Quat& q = state.pose.orientation;
  state.velocity_m_s = moved.velocity_m_s - moved.spin_rad_s.cross(q * body.center_of_mass_m);
  state.angular_velocity_body_rad_s = q.conjugate() * moved.spin_rad_s;
}

double kinetic_energy_J(const Body& body, const BodyState& state) {
  if (!body.is_dynamic()) return 0;
  const Vec3& spin = state.angular_velocity_body_rad_s;
  const Vec3 velocity = moving(body, state).velocity_m_s;
  return (body.mass_kg * velocity.squaredNorm() + spin.dot(body.inertia_kg_m2 * spin)) / 2;
}

}  // namespace animado::colisao
