// Several contacts at once, at velocity level: block projected Gauss–Seidel.
//
// Each contact c wants an impulse P_c in Coulomb's cone, |P_t| ≤ μ P_n, such that
//
//   0 ≤ P_n  ⊥  u_n − allowed ≥ 0        (it pushes only as long as they would approach faster than allowed)
//   P_t = −μ P_n u_t/|u_t| where u_t ≠ 0  (it slides against friction, or sticks)
//
// with u the relative velocity after all impulses. One visit solves these for one contact, the others held,
// in closed form while it sticks and by a contraction while it slides; an iteration visits all contacts
// forwards and then backwards. Jourdan, Alart, Jean, "A Gauss–Seidel like algorithm to solve frictional
// contact problems", CMAME 155 (1998), 31–47. Near jamming that takes thousands of iterations, so that a
// small island which is slow to converge is accelerated (anderson.hpp).
#pragma once

#include <span>

#include "colisao/bodies.hpp"

namespace animado::colisao {

struct ContactConstraint {
  int a = 0, b = 0;  // columns of `bodies`
  Vec3 point_m = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();  // unit, from b towards a
  double friction = 0;
  double allowed_m_s = 0;           // the normal velocity may not be less
  Vec3 impulse_N_s = Vec3::Zero();  // in: a guess; out: the answer, on a, world
};

struct SolverReport {
  bool converged = true;
  int iterations = 0;
  double residual_m_s = 0;  // largest change of a relative velocity in the last iteration
};

// Gives `bodies` the velocities after the impulses. Converged when an iteration changes no relative velocity
// by more than `tolerance` times the largest one of the start; else it stops after a number of iterations
// that depends on the number of contacts.
SolverReport solve_contacts(std::span<Moving> bodies, std::span<ContactConstraint> contacts,
                            double tolerance);

}  // namespace animado::colisao
