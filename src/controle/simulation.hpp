// A scene made ready to step: the parts of a run that know each other, made in the order in which they need
// each other.
#pragma once

#include <memory>

#include "controle/balance.hpp"
#include "controle/contact_forces.hpp"
#include "controle/preparation.hpp"
#include "controle/stepper.hpp"

namespace animado::controle {

class Simulation {
 public:
  // `name` tells this run's shared arrays from another's; calls go to `log`, events to `report`.
  Simulation(Scene scene, rpc::Suite& suite, const std::string& name, rpc::Log& log, Stepper::Report report);

  const Scene& scene() const { return scene_; }
  Stepper& stepper() { return stepper_; }
  Meter& meter() { return meter_; }

  // Kinetic and potential energy, and what contact springs hold; momenta.
  Balance balance();

  // Takes an edited scene's expressions from now on: forces, torques and names. Throws Error when one of them
  // cannot be compiled, and then nothing has changed.
  void edit(Scene edited);

 private:
  Scene scene_;
  Meter meter_;
  Workspace workspace_;
  std::vector<Inertia> inertias_;
  colisao::Client colisao_;
  EquationsOfMotion equations_;
  Forces forces_;
  Kinematics kinematics_;
  std::unique_ptr<SpringContacts> springs_;  // response spring
  FreeMotion motion_;
  Stepper stepper_;
};

}  // namespace animado::controle
