#include "controle/run.hpp"

#include <chrono>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "controle/live_names.hpp"
#include "controle/overlap.hpp"
#include "controle/scene_physics.hpp"
#include "controle/simulation.hpp"

namespace animado::controle {
namespace {

template <class T>
uint64_t hash_of(T content) {
  Fnv1a hash;
  hash.add(content);
  return hash.value();
}

Momentum momentum(const Balance& balance) {
  return {balance.linear_momentum_kg_m_s, balance.angular_momentum_kg_m2_s};
}

// What the summary can say before the first frame.
Summary opening(const Scene& scene, Simulation& simulation) {
  Summary summary;
  summary.scene = scene.path;
  summary.scene_hash = hash_of(std::string_view(scene.text));
  summary.bodies = static_cast<int64_t>(scene.bodies.size());
  const Balance start = simulation.balance();
  summary.energy.initial_J = start.energy_J();
  summary.momentum_initial = momentum(start);
  return summary;
}

// length_s: of the frame; steps: when it began.
FrameFacts facts_at(double time_s, double length_s, int64_t steps, double initial_J, Simulation& simulation) {
  const Stepper& stepper = simulation.stepper();
  const Counts& counts = stepper.counts();
  const Balance now = simulation.balance();
  EnergyLedger ledger = stepper.flows();
  ledger.initial_J = initial_J;
  ledger.final_J = now.energy_J();
  FrameFacts facts;
  facts.time_s = time_s;
  facts.step_s = counts.steps > steps ? length_s / static_cast<double>(counts.steps - steps) : 0;
  facts.steps = counts.steps;
  facts.impacts = counts.impacts;
  facts.contacts = stepper.contacts();
  facts.kinetic_J = now.kinetic_J;
  facts.potential_J = now.potential_J;
  facts.elastic_J = now.elastic_J;
  facts.work_in_J = ledger.work_in_J;
  facts.dissipated_impacts_J = ledger.dissipated_impacts_J;
  facts.dissipated_friction_J = ledger.dissipated_friction_J;
  facts.dissipated_damping_J = ledger.dissipated_damping_J;
  facts.residual_J = ledger.residual_J();
  facts.linear_kg_m_s = now.linear_momentum_kg_m_s;
  facts.angular_kg_m2_s = now.angular_momentum_kg_m2_s;
  return facts;
}

void close(Summary& summary, Simulation& simulation, double wall_time_s) {
  const Stepper& stepper = simulation.stepper();
  const Balance end = simulation.balance();
  const double initial_J = summary.energy.initial_J;
  summary.energy = stepper.flows();
  summary.energy.initial_J = initial_J;
  summary.energy.final_J = end.energy_J();
  summary.momentum_final = momentum(end);
  summary.steps = stepper.counts().steps;
  summary.impacts = stepper.counts().impacts;
  summary.state_hash = hash_of(std::span(stepper.state(), kStateRows * simulation.scene().bodies.size()));
  summary.wall_time_s = wall_time_s;
  double elsewhere_s = 0;
  for (const auto& [module, share] : simulation.meter().shares()) {
    summary.time_per_module_s.emplace_back(module, share.seconds);
    summary.messages_per_module.emplace_back(module, share.messages);
    elsewhere_s += share.seconds;
  }
  summary.time_per_module_s.emplace_back("controle", wall_time_s - elsewhere_s);
}

}  // namespace

std::vector<ResultBody> result_bodies(const Scene& scene) {
  std::vector<ResultBody> bodies;
  for (const Body& body : scene.bodies) {
    bodies.push_back({body.name,
                      body.shape,
                      body.motion,
                      body.mass_kg,
                      {body.color.r, body.color.g, body.color.b},
                      body.rotation_order});
  }
  return bodies;
}

Summary run(const RunOptions& options, rpc::Suite& suite) {
  const auto begin = std::chrono::steady_clock::now();
  const auto wall_time_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const Scene scene = read_scene(options.scene);
  refuse_overlap(scene, suite);

  Results results(options.directory, result_bodies(scene), scene.text);
  if (options.physics_extensions)
    results.with_physics(physics_of(scene), combination_of(scene.world.restitution_rule));
  rpc::Log log("controle", options.directory / "logs" / "controle.log");
  Simulation simulation(scene, suite, options.name, log, [&](const Event& event) { results.event(event); });
  LiveNames names(suite, simulation, options.name, [&](const Event& event) { results.event(event); });
  names.replay(options.edits);
  Stepper& stepper = simulation.stepper();
  Summary summary = opening(scene, simulation);

  FrameFacts facts;
  const std::vector<double> times = scene.time.frame_times();
  ProgressReports progress(options.progress, stepper, static_cast<int64_t>(times.size()), times.back(),
                           static_cast<int64_t>(scene.bodies.size()));
  const auto stop_or_go_on = [&] {
    progress.after_step();
    return options.stop();
  };
  const auto finish = [&](RunStatus status) {
    summary.status = status;
    close(summary, simulation, wall_time_s());
    results.finish(summary);
    summary.frames = results.frames();
  };
  try {
    for (size_t frame = 0; frame < times.size(); ++frame) {
      if (frame > 0 && !stepper.advance_to(times[frame], stop_or_go_on)) break;
      const double length_s = frame > 0 ? times[frame] - times[frame - 1] : 0;
      facts = facts_at(times[frame], length_s, facts.steps, summary.energy.initial_J, simulation);
      results.frame(facts, {stepper.state(), kStateRows * scene.bodies.size()});
      names.publish();
      progress.at_frame(static_cast<int64_t>(frame + 1));
      options.pace(times[frame]);
      names.take_edits();
      if (options.stop()) break;
    }
  } catch (const Error& error) {
    finish(error.code() == Code::diverged ? RunStatus::diverged : RunStatus::interrupted);
    throw;
  }
  finish(options.stop() ? RunStatus::interrupted : RunStatus::done);
  return summary;
}

}  // namespace animado::controle
