// What is kept, or whose change has to be accounted for: energy and momentum of the dynamic bodies.
#pragma once

#include <span>
#include <vector>

#include "controle/equations_of_motion.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {

struct Balance {
  double kinetic_J = 0;
  double potential_J = 0;  // in the scene's uniform gravity, zero at the world's origin
  double elastic_J = 0;    // in contact springs
  Vec3 linear_momentum_kg_m_s = Vec3::Zero();
  Vec3 angular_momentum_kg_m2_s = Vec3::Zero();  // about the world's origin

  double energy_J() const { return kinetic_J + potential_J + elastic_J; }
};

// Sums over the dynamic bodies, in their order. state: (13, bodies).
Balance balance(const Scene& scene, std::span<const Inertia> inertias, const double* state);

// Where the centre of mass of a body is.
Vec3 center_of_mass(const Inertia& inertia, const Pose& pose);

}  // namespace animado::controle
