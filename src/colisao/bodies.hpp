// What the response needs to know of each body, and a body as the solvers see it: world axes, about its
// centre of mass.
#pragma once

#include <vector>

#include "base/shape.hpp"
#include "base/state.hpp"

namespace animado::colisao {

// How a pair's restitution is made of its bodies'.
enum class RestitutionRule { product, min, max, mean };

struct Body {
  Motion motion = Motion::dynamic;
  double mass_kg = 0;                           // of a dynamic body; the others count as infinitely heavy
  Vec3 center_of_mass_m = Vec3::Zero();         // body frame
  Mat3 inertia_kg_m2 = Mat3::Identity();        // about the centre of mass, body axes
  Mat3 inverse_inertia_1_kg_m2 = Mat3::Zero();  // its inverse; zero unless dynamic
  double inverse_mass_1_kg = 0;                 // zero unless dynamic
  double restitution = 0.5, friction = 0;
  double radius_m = 0;  // of a ball about the centre of mass that holds the solid

  bool is_dynamic() const { return motion == Motion::dynamic; }
};

// A dynamic body with its inverses filled in. Throws refused when the mass or the inertia is not positive.
Body dynamic_body(double mass_kg, const Mat3& inertia_kg_m2, const Vec3& center_of_mass_m = Vec3::Zero());
// A body that nothing can push: fixed or kinematic.
Body immovable_body(Motion motion);

struct Surface {  // of a pair
  double restitution = 0, friction = 0;
};

struct Bodies {
  std::vector<Body> list;  // in the order of the state's columns
  RestitutionRule rule = RestitutionRule::product;
  double contact_threshold_m_s = 0.01;

  size_t size() const { return list.size(); }
  const Body& operator[](size_t i) const { return list[i]; }
  Surface surface(int i, int j) const;
};

// A body at one moment, in world axes about its centre of mass.
struct Moving {
  Vec3 center_m = Vec3::Zero();
  Vec3 velocity_m_s = Vec3::Zero();  // of the centre of mass
  Vec3 spin_rad_s = Vec3::Zero();
  double inverse_mass_1_kg = 0;
  Mat3 inverse_inertia_1_kg_m2 = Mat3::Zero();  // world axes

  bool is_movable() const { return inverse_mass_1_kg > 0; }
  Vec3 velocity_at(const Vec3& point_m) const { return velocity_m_s + spin_rad_s.cross(point_m - center_m); }
  void push(const Vec3& impulse_N_s, const Vec3& point_m) {
    velocity_m_s += inverse_mass_1_kg * impulse_N_s;
    spin_rad_s += inverse_inertia_1_kg_m2 * (point_m - center_m).cross(impulse_N_s);
  }
};

Moving moving(const Body& body, const BodyState& state);
std::vector<Moving> moving(const Bodies& bodies, const std::vector<BodyState>& states);
// Puts the velocities of `moved` into `state`, whose pose stays.
void set_velocities(const Body& body, const Moving& moved, BodyState& state);

// Kinetic energy of a dynamic body; 0 for the others.
double kinetic_energy_J(const Body& body, const BodyState& state);

}  // namespace animado::colisao
