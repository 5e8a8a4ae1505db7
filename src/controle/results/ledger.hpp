// Where the energy went. Over a run,
//
//   E(final) = E(initial) + W − D(impacts) − D(friction) − D(damping) + residual,
//
// with E the kinetic energy of the dynamic bodies, their potential energy in the scene's uniform gravity and
// what contact springs store; W the work of the scene's forces and torques. The residual is what the numbers
// made or lost: it tells how true a run is.
#pragma once

namespace animado::controle {

struct EnergyLedger {
  double initial_J = 0, final_J = 0;
  double work_in_J = 0;
  double dissipated_impacts_J = 0, dissipated_friction_J = 0, dissipated_damping_J = 0;

  double residual_J() const {
    const double dissipated_J = dissipated_impacts_J + dissipated_friction_J + dissipated_damping_J;
    return final_J - (initial_J + work_in_J - dissipated_J);
  }
};

}  // namespace animado::controle
