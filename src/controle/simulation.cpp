#include "controle/simulation.hpp"

namespace animado::controle {
namespace {

std::unique_ptr<SpringContacts> springs(const Scene& scene, colisao::Client& colisao, Workspace& workspace,
                                        Meter& meter, std::span<const Inertia> inertias) {
  if (scene.world.response != Response::spring) return nullptr;
  return std::make_unique<SpringContacts>(colisao, workspace, meter, scene.world, inertias);
}

}  // namespace

Simulation::Simulation(Scene scene, rpc::Suite& suite, const std::string& name, rpc::Log& log,
                       Stepper::Report report)
    : scene_(std::move(scene)),
      meter_(log, name),
      workspace_(suite.arrays(), name),
      inertias_(inertias(scene_)),
      colisao_(suite.channel("colisao")),
      equations_(inertias_),
      forces_(scene_, inertias_, drives(scene_, SceneScope(scene_))),
      kinematics_(paths(scene_, SceneScope(scene_))),
      springs_(
          (colisao_.prepare(colliders(scene_)), springs(scene_, colisao_, workspace_, meter_, inertias_))),
      motion_(suite, workspace_, meter_, scene_.world.method, equations_, forces_, kinematics_,
              springs_.get()),
      stepper_(scene_, inertias_, motion_, forces_, colisao_, meter_, std::move(report)) {}

Balance Simulation::balance() {
  Balance sum = controle::balance(scene_, inertias_, stepper_.state());
  if (springs_) sum.elastic_J = springs_->stored_J(stepper_.lanes());
  return sum;
}

void Simulation::edit(Scene edited) {
  const SceneScope scope(edited);
  auto new_drives = drives(edited, scope);
  auto new_paths = paths(edited, scope);
  scene_ = std::move(edited);
  forces_.replace(std::move(new_drives));
  kinematics_.replace(std::move(new_paths));
  stepper_.forget_rates();
}

}  // namespace animado::controle
