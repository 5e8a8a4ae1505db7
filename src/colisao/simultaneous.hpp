// Several impacts at one time, answered together by generalized reflections:
// Smith, Kaufman, Vouga, Tamstorf, Grinspun, "Reflections on Simultaneous Impact", ACM Trans. Graph. 31, 4
// (SIGGRAPH 2012), article 106.
//
// A round takes the contacts that approach (and only those) and answers each group of them that shares bodies
// as one:
//
//   0 ≤ P_n  ⊥  u_n' + ε u_n ≥ 0,   P in Coulomb's cone.
//
// What their impulses make approach is the next round. So a cradle hands its momentum on ball by ball, and
// the corners of a box that lands flat are answered at once. Each round loses ½ Σ P·(u + u') ≤ 0. When
// nothing approaches faster than the contact threshold (or all ε are 0) one inelastic projection over all
// contacts ends the rounds.
//
// Deviations: ε per contact inside the complementarity, which keeps the energy bounded when they differ;
// Coulomb's friction, held back where it would feed energy in. A group of one contact is answered in closed
// form (impulse.hpp) or by the fifteen equations.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "colisao/bodies.hpp"
#include "colisao/contact.hpp"
#include "colisao/contact_solver.hpp"

namespace animado::colisao {

struct Meet {
  Contact contact;  // a and b are columns of `bodies`
  Surface surface;
  double allowed_m_s = 0;  // ≤ 0: approach up to this is none (a gap that stays open for the time at hand)
};

// P of one contact point that is to have the normal velocity `rebound_m_s`.
using PointResponse = std::function<Vec3(const Moving& a, const Moving& b, const Contact& contact,
                                         double friction, double rebound_m_s)>;

PointResponse closed_form();

struct AnsweredImpact {
  int meet = 0;                     // index of the contact
  Vec3 impulse_N_s = Vec3::Zero();  // on a, world; the sum over the rounds
  double approach_m_s = 0;          // the fastest at which it was answered
  double separation_m_s = 0;        // in the end
};

struct SimultaneousResult {
  std::vector<AnsweredImpact> impacts;  // the contacts that carried an impulse, in order
  double dissipated_impact_J = 0, dissipated_friction_J = 0;  // along the normals; tangential
  double work_of_told_J = 0;                                  // by kinematic bodies on the others
  int rounds = 0;
  bool converged =
      true;  // nothing approaches faster than allowed; false when the last projection did not converge
  double residual_m_s = 0;  // its last change of a relative velocity
};

// Gives `bodies` their velocities after the impacts. Groups of touching bodies in which nothing approaches
// faster than the threshold are left as they are, to the last bit.
SimultaneousResult respond_together(std::span<Moving> bodies, std::span<const Meet> meets,
                                    double contact_threshold_m_s,
                                    const PointResponse& respond = closed_form());

}  // namespace animado::colisao
