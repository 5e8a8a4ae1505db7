// Elastic contact: forces instead of impulses (paper, section 3.4.2, equation 2).
//
//   F_elastic = k ρ,   F_damping = k' v
//
// Deviation: the paper takes ρ from the point of the collision to the centre of mass, and v of the object;
// forces would then act on bodies that merely touch. Here ρ is the overlap of the surfaces along the normal
// and v the speed at which they near each other at the point, and bodies only push: F_n = max(0, k ρ + k' v).
// Each contact point has its own spring, so a face on a face is as stiff as its points together.
//
// Coulomb's friction, F_t = −μ F_n u_t / √(u_t² + s²): s is the contact threshold, under which sliding counts
// as none; the force has no jump there, as an integrator of fourth order needs.
#pragma once

#include <span>
#include <vector>

#include "colisao/bodies.hpp"
#include "colisao/contact.hpp"

namespace animado::colisao {

struct SpringForces {
  std::vector<double> wrenches;  // shape (6, bodies): force, and torque about the centre of mass, world
  double stored_J = 0;           // ½ k ρ² of each contact
};

// states: one a body. contacts: those of the state, overlapping or not; stiffness, damping ≥ 0.
SpringForces spring_forces(const Bodies& bodies, const std::vector<BodyState>& states,
                           std::span<const Contact> contacts, double stiffness_N_m, double damping_N_s_m);

}  // namespace animado::colisao
