#include "colisao/impulse.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace animado::colisao {

namespace {

Mat3 inverse_mass_at(const Moving& body, const Vec3& point_m) {
  const Mat3 arm = cross_matrix(point_m - body.center_m);
  return body.inverse_mass_1_kg * Mat3::Identity() - arm * body.inverse_inertia_1_kg_m2 * arm;
}

Vec3 tangential(const Vec3& v, const Vec3& k) {
  return v - v.dot(k) * k;
}

// The largest s in [0, 1] for which start + s·change does not raise the energy, given that start does not.
// The change of energy by an impulse P is P·(u + ½ K P), a parabola in s.
double share_without_gain(const Mat3& K, const Vec3& u, const Vec3& start, const Vec3& change) {
  const double gain_at_0 = start.dot(u + K * start / 2);
  const double slope = change.dot(u + K * start);
  const double bend = change.dot(K * change) / 2;
  if (gain_at_0 + slope + bend <= 0 || bend <= 0) return 1;
  const double root = std::sqrt(std::max(0.0, slope * slope - 4 * bend * gain_at_0));
  return std::clamp((root - slope) / (2 * bend), 0.0, 1.0);
}

// P = P₀ + s d with d = β k − t̂, β = k·K t̂ / k·K k: friction against t̂ that leaves the normal velocity as P₀
// made it.
PointImpulse sliding(const Mat3& K, const Vec3& k, const Vec3& u, const Vec3& frictionless, double mu) {
  const Vec3 slip = tangential(u, k);
  const double speed = slip.norm();
  if (speed == 0) return {frictionless, Friction::given};
  const Vec3 t = slip / speed;
  const double beta = k.dot(K * t) / k.dot(K * k);
  const Vec3 d = beta * k - t;
  const double on_cone =
      mu * beta < 1 ? mu * frictionless.dot(k) / (1 - mu * beta) : std::numeric_limits<double>::infinity();
  const double stops = std::max(0.0, -d.dot(u + K * frictionless) / d.dot(K * d));
  if (on_cone <= stops) return {frictionless + on_cone * d, Friction::slides};
  return {frictionless + stops * d, Friction::given};
}

}  // namespace

Vec3 relative_velocity(const Moving& a, const Moving& b, const Vec3& point_m) {
  return a.velocity_at(point_m) - b.velocity_at(point_m);
}

Mat3 inverse_mass_at(const Moving& a, const Moving& b, const Vec3& point_m) {
  return inverse_mass_at(a, point_m) + inverse_mass_at(b, point_m);
}

double work_of_told_J(const Moving& a, const Moving& b, const Vec3& point_m, const Vec3& impulse_N_s) {
  double work = 0;
  if (!b.is_movable()) work += impulse_N_s.dot(b.velocity_at(point_m));
  if (!a.is_movable()) work -= impulse_N_s.dot(a.velocity_at(point_m));
  return work;
}

double rebound_m_s(double normal_velocity_m_s, double restitution, double contact_threshold_m_s) {
  return normal_velocity_m_s < -contact_threshold_m_s ? -restitution * normal_velocity_m_s : 0.0;
}

PointImpulse point_impulse(const Moving& a, const Moving& b, const Contact& contact, double friction,
                           double rebound_m_s) {
  assert(a.is_movable() || b.is_movable());
  const Vec3& k = contact.normal;
  const Vec3 u = relative_velocity(a, b, contact.point_m);
  assert(u.dot(k) <= rebound_m_s);
  const Mat3 K = inverse_mass_at(a, b, contact.point_m);
  const Vec3 frictionless = (rebound_m_s - u.dot(k)) / k.dot(K * k) * k;
  if (friction == 0) return {frictionless, Friction::given};

  const Vec3 sticking = K.inverse() * (rebound_m_s * k - u);
  const double normal = sticking.dot(k);
  if (tangential(sticking, k).norm() > friction * normal) return sliding(K, k, u, frictionless, friction);
  const double share = share_without_gain(K, u, frictionless, sticking - frictionless);
  if (share == 1) return {sticking, Friction::sticks};
  return {frictionless + share * (sticking - frictionless), Friction::given};
}

}  // namespace animado::colisao
