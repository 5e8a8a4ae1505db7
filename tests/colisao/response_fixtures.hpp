// Bodies for the tests of the response, made by hand.
#pragma once

#include "colisao/bodies.hpp"
#include "colisao/contact.hpp"

namespace animado::colisao::testing {

inline Moving ball(double mass_kg, double radius_m, const Vec3& center_m, const Vec3& velocity_m_s,
                   const Vec3& spin_rad_s = Vec3::Zero()) {
  Moving m;
  m.center_m = center_m;
  m.velocity_m_s = velocity_m_s;
  m.spin_rad_s = spin_rad_s;
  m.inverse_mass_1_kg = 1 / mass_kg;
  m.inverse_inertia_1_kg_m2 = Mat3::Identity() / (0.4 * mass_kg * radius_m * radius_m);
  return m;
}

inline Moving block(double mass_kg, const Vec3& half_m, const Vec3& center_m, const Vec3& velocity_m_s,
                    const Vec3& spin_rad_s = Vec3::Zero()) {
  Moving m = ball(mass_kg, 1, center_m, velocity_m_s, spin_rad_s);
  const Vec3 square = half_m.cwiseProduct(half_m);
  const Vec3 inertia =
      mass_kg / 3 * Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  m.inverse_inertia_1_kg_m2 = inertia.cwiseInverse().asDiagonal();
  return m;
}

inline Moving immovable(const Vec3& velocity_m_s = Vec3::Zero()) {
  Moving m;
  m.velocity_m_s = velocity_m_s;
  return m;
}

inline Contact contact(int a, int b, const Vec3& point_m, const Vec3& normal, double gap_m = 0,
                       int feature = 0) {
  Contact c;
  c.a = a;
  c.b = b;
  c.point_m = point_m;
  c.normal = normal;
  c.gap_m = gap_m;
  c.feature = feature;
  return c;
}

// Of movable bodies.
inline double kinetic_energy(const Moving& m) {
  if (!m.is_movable()) return 0;
  return m.velocity_m_s.squaredNorm() / (2 * m.inverse_mass_1_kg) +
         m.spin_rad_s.dot(m.inverse_inertia_1_kg_m2.inverse() * m.spin_rad_s) / 2;
}
inline Vec3 momentum(const Moving& m) {
  return m.is_movable() ? Vec3(m.velocity_m_s / m.inverse_mass_1_kg) : Vec3(0, 0, 0);
}
inline Vec3 angular_momentum(const Moving& m) {
  if (!m.is_movable()) return Vec3::Zero();
  return m.center_m.cross(momentum(m)) + m.inverse_inertia_1_kg_m2.inverse() * m.spin_rad_s;
}

}  // namespace animado::colisao::testing
