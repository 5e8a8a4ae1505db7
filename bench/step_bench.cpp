// What a step costs with five processes and with one: RK4 with egesp, fred and colisao in the loop, for few
// bodies and for many.
#include <benchmark/benchmark.h>

#include "animado/in_process.hpp"
#include "controle/simulation.hpp"
#include "free_tops.hpp"
#include "rpc/one_core.hpp"
#include "services.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::bench {
namespace {

constexpr int kWarmUp = 10;  // steps: the first ones touch every page for the first time

void step(benchmark::State& state, rpc::Suite& suite) {
  static int runs = 0;  // shared arrays are named once
  rpc::Log silent;
  controle::Simulation simulation(free_tops_scene(static_cast<size_t>(state.range(0))), suite,
                                  fmt::format("bench/{}", ++runs), silent, [](const auto&) {});
  int steps = 0;
  while (steps < kWarmUp) simulation.stepper().advance_to(kStep_s * ++steps);
  for (auto _ : state) simulation.stepper().advance_to(kStep_s * ++steps);
}

// As `animado run --in-process` starts them: with their logs, which the processes write too.
void StepInProcess(benchmark::State& state) {
  const TemporaryDirectory logs;
  const auto suite = suite_in_process(logs.path());
  step(state, *suite);
}

// As `animado run` starts them.
void StepSockets(benchmark::State& state) {
  const rpc::OneCore core;
  suite::Services services;
  step(state, services.suite());
}

BENCHMARK(StepInProcess)->Arg(2)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(StepSockets)->Arg(2)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace
}  // namespace animado::bench
