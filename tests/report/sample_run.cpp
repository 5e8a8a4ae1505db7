#include "tests/report/sample_run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "controle/results/summary_json.hpp"

namespace animado::report {
namespace {

using controle::RecordedRun;
using controle::RecordedState;

constexpr double kFrame_s = 1.0 / 60;

Shape shape_of(size_t body) {
  const Hull tetrahedron = {{{-0.2, -0.2, -0.2}, {0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}},
                            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const std::array<Shape, 6> shapes = {Sphere{0.3},         Box{{0.25, 0.25, 0.25}}, Capsule{0.15, 0.2},
                                       Cylinder{0.2, 0.25}, Cone{0.25, 0.5},         tetrahedron};
  return shapes[body % shapes.size()];
}

// A number in 0 … 1 that looks like chance: a motion without any would pack better than a real one.
double noise(size_t a, size_t b) {
  const double x = std::sin(static_cast<double>(a) * 12.9898 + static_cast<double>(b) * 78.233) * 43758.5453;
  return x - std::floor(x);
}

RecordedState state_of(size_t body, double time_s) {
  const double phase = noise(body, 1) * 6, speed = 1 + noise(body, 2) * 4;
  const auto column = static_cast<double>(body % 32) - 16, row = static_cast<double>(body / 32) - 16;
  const double bounce = std::abs(std::sin(speed * time_s + phase));
  const double jitter = noise(body, static_cast<size_t>(time_s * 6000)) * 1e-2;
  const Vec3 axis = Vec3(noise(body, 3), noise(body, 4), noise(body, 5) + 0.1).normalized();
  RecordedState state;
  state.pose.position_m = {column + 0.3 * std::sin(time_s + phase), 0.4 + 3 * bounce + jitter, row};
  state.pose.orientation = Quat(Eigen::AngleAxisd(speed * time_s + jitter, axis));
  state.velocity_m_s = {0.3 * std::cos(time_s + phase), 3 * speed * std::cos(speed * time_s + phase), jitter};
  state.angular_velocity_rad_s = speed * axis * (1 + jitter);
  return state;
}

void add_bodies(size_t bodies, RecordedRun& run) {
  for (size_t i = 0; i < bodies; ++i) {
    run.bodies.push_back({.name = fmt::format("body{}", i),
                          .mass_kg = 1,
                          .color_srgb = {noise(i, 6), noise(i, 7), noise(i, 8)},
                          .shape = shape_of(i)});
  }
  run.bodies.push_back({.name = "floor", .motion = Motion::fixed, .shape = HalfSpace{Vec3::UnitY(), 0}});
}

// Each pair of neighbours meets twice a second; strong impacts are rare.
void add_impacts(size_t bodies, size_t frame, RecordedRun& run) {
  constexpr double kShare = 2 * kFrame_s;
  const double time_s = kFrame_s * static_cast<double>(frame);
  for (size_t i = 0; i + 1 < bodies; i += 2) {
    if (noise(i, frame) > kShare) continue;
    controle::Event& impact = run.events.emplace_back();
    impact.time_s = time_s;
    impact.bodies = {run.bodies[i].name, run.bodies[i + 1].name};
    impact.point_m = state_of(i, time_s).pose.position_m;
    impact.normal = Vec3::UnitY();
    impact.impulse_N_s = Vec3(0, -std::log(1 - noise(i, frame + 1)), 0);
    impact.approach_m_s = 1;
    impact.separation_m_s = 0.5;
  }
}

controle::FrameFacts facts_of(size_t frame, double time_s, size_t impacts) {
  return {.time_s = time_s,
          .step_s = frame > 0 ? kFrame_s / 4 : 0,
          .steps = static_cast<int64_t>(4 * frame),
          .impacts = static_cast<int64_t>(impacts),
          .kinetic_J = 100 + std::cos(time_s),
          .potential_J = 50 - std::cos(time_s),
          .residual_J = 1e-12 * noise(frame, 9)};
}

}  // namespace

RecordedRun sample_run(size_t bodies, size_t frames) {
  RecordedRun run;
  add_bodies(bodies, run);
  for (size_t k = 0; k < frames; ++k) {
    const double time_s = kFrame_s * static_cast<double>(k);
    run.times_s.push_back(time_s);
    for (size_t i = 0; i < bodies; ++i) run.states.push_back(state_of(i, time_s));
    run.states.emplace_back();  // the floor
    add_impacts(bodies, k, run);
    run.facts.push_back(facts_of(k, time_s, run.events.size()));
  }
  run.scene_text = "# a sample that nobody simulated\n";
  run.summary_json = controle::summary_text({.scene = "sample.animado",
                                             .frames = static_cast<int64_t>(frames),
                                             .bodies = static_cast<int64_t>(run.bodies.size()),
                                             .steps = static_cast<int64_t>(4 * frames)});
  return run;
}

}  // namespace animado::report
