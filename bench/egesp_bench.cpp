// 10,000 systems of one size, interleaved as the time step has them: egesp's kernels beside Eigen's LU of
// fixed size. `ns_a_solve` is the time of one system, `eigen_ratio` how many times as long Eigen's LU of the
// same pivoting (PartialPivLU, FullPivLU) takes in the same run, `backward_error` the largest ‖b − A x‖ /
// (‖A‖ ‖x‖ + ‖b‖) of the batch.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <chrono>

#include "egesp/batch.hpp"
#include "egesp/prepared.hpp"
#include "huge_pages.hpp"

namespace animado::bench {
namespace {

using egesp::InstructionSet;

constexpr size_t kSystems = 10000;

template <int N>
struct Systems {
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  HugeVector<double> matrices = HugeVector<double>(N * N * kSystems),
                     sides = HugeVector<double>(N * kSystems), solutions = sides;
  HugeVector<Matrix> a = HugeVector<Matrix>(kSystems);
  HugeVector<Vector> b = HugeVector<Vector>(kSystems), x = b;

  Systems() {
    std::srand(12345);  // Eigen's Random draws from it
    for (size_t s = 0; s < kSystems; ++s) {
      a[s] = Matrix::Random();
      b[s] = Vector::Random();
      for (int e = 0; e < N * N; ++e) matrices[static_cast<size_t>(e) * kSystems + s] = a[s](e / N, e % N);
      for (int e = 0; e < N; ++e) sides[static_cast<size_t>(e) * kSystems + s] = b[s][e];
    }
  }

  template <class Lu>
  void solve_by_eigen() {
    for (size_t s = 0; s < kSystems; ++s) x[s] = Lu(a[s]).solve(b[s]);
  }
  void solve_by_egesp(InstructionSet instructions, bool complete) {
    const auto refusals =
        solve_batch({matrices, sides, solutions, kSystems, N, 1, true}, {complete, 0}, instructions);
    benchmark::DoNotOptimize(refusals.size());
  }
  void take_solutions() {
    for (size_t s = 0; s < kSystems; ++s) {
      for (int e = 0; e < N; ++e) x[s][e] = solutions[static_cast<size_t>(e) * kSystems + s];
    }
  }
  double backward_error() const {
    double worst = 0;
    for (size_t s = 0; s < kSystems; ++s) {
      const double residual = (b[s] - a[s] * x[s]).template lpNorm<Eigen::Infinity>();
      const double norm = a[s].cwiseAbs().rowwise().sum().maxCoeff();
      worst = std::max(worst, residual / (norm * x[s].template lpNorm<Eigen::Infinity>() +
                                          b[s].template lpNorm<Eigen::Infinity>()));
    }
    return worst;
  }
};

template <class Work>
double ns_a_solve(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() /
         kSystems;
}

// Both sides take turns, and the best of each counts: what else runs on the machine meets both.
template <int N, template <class> class Lu, class Solve>
void measure(benchmark::State& state, const Solve& solve,
             const std::function<void(Systems<N>&)>& finish = {}) {
  Systems<N> systems;
  double best = HUGE_VAL, eigen = HUGE_VAL;
  for (auto _ : state) {
    const double ns = ns_a_solve([&] { solve(systems); });
    state.SetIterationTime(ns * kSystems * 1e-9);
    best = std::min(best, ns);
    eigen = std::min(eigen,
                     ns_a_solve([&] { systems.template solve_by_eigen<Lu<typename Systems<N>::Matrix>>(); }));
  }
  solve(systems);
  if (finish) finish(systems);
  state.counters["ns_a_solve"] = best;
  state.counters["eigen_ratio"] = eigen / best;
  state.counters["backward_error"] = systems.backward_error();
}

InstructionSet instruction_set(benchmark::State& state) {
  const auto instructions = static_cast<InstructionSet>(state.range(0));
  if (instructions > egesp::widest_instruction_set()) state.SkipWithError("not on this machine");
  state.SetLabel(std::array{"scalar", "SSE2", "AVX2", "AVX-512"}[static_cast<size_t>(instructions)]);
  return instructions;
}

template <int N, bool kComplete, template <class> class Lu>
void Egesp(benchmark::State& state) {
  const InstructionSet instructions = instruction_set(state);
  if (instructions > egesp::widest_instruction_set()) return;
  measure<N, Lu>(
      state, [&](Systems<N>& systems) { systems.solve_by_egesp(instructions, kComplete); },
      [](Systems<N>& systems) { systems.take_solutions(); });
}

// The matrices factored before; beside Eigen, which factors them. kAlike: all systems have one matrix.
template <bool kAlike>
void Prepared(benchmark::State& state) {
  const InstructionSet instructions = instruction_set(state);
  if (instructions > egesp::widest_instruction_set()) return;
  std::unique_ptr<egesp::PreparedBatch> prepared;
  const auto solve = [&](Systems<6>& systems) {
    if (!prepared) {
      HugeVector<double> matrices = systems.matrices;
      for (size_t e = 0; kAlike && e < matrices.size(); ++e) matrices[e] = matrices[e / kSystems * kSystems];
      prepared = egesp::prepare({matrices, kSystems, 6, true}, {}, instructions);
    }
    prepared->solve({systems.sides, 1, true}, systems.solutions);
  };
  measure<6, Eigen::PartialPivLU>(state, solve, [](Systems<6>& systems) {
    if (!kAlike) systems.take_solutions();
  });
}

template <int N, template <class> class Lu>
void EigenLu(benchmark::State& state) {
  measure<N, Lu>(
      state, [](Systems<N>& systems) { systems.template solve_by_eigen<Lu<typename Systems<N>::Matrix>>(); });
}

#define ANIMADO_MEASURE(what, name) \
  BENCHMARK(what)->Name("egesp/" name)->UseManualTime()->Unit(benchmark::kMillisecond)

ANIMADO_MEASURE((EigenLu<6, Eigen::PartialPivLU>), "6x6/eigen_partial");
ANIMADO_MEASURE((EigenLu<6, Eigen::FullPivLU>), "6x6/eigen_full");
ANIMADO_MEASURE((Egesp<6, false, Eigen::PartialPivLU>), "6x6/partial")->DenseRange(0, 3);
ANIMADO_MEASURE((Egesp<6, true, Eigen::FullPivLU>), "6x6/complete")->DenseRange(0, 3);
ANIMADO_MEASURE(Prepared<false>, "6x6/prepared")->DenseRange(1, 3);
ANIMADO_MEASURE(Prepared<true>, "6x6/prepared_alike")->DenseRange(1, 3);
ANIMADO_MEASURE((EigenLu<15, Eigen::PartialPivLU>), "15x15/eigen_partial");
ANIMADO_MEASURE((EigenLu<15, Eigen::FullPivLU>), "15x15/eigen_full");
ANIMADO_MEASURE((Egesp<15, false, Eigen::PartialPivLU>), "15x15/partial")->DenseRange(0, 3);
ANIMADO_MEASURE((Egesp<15, true, Eigen::FullPivLU>), "15x15/complete")->DenseRange(0, 3);

}  // namespace
}  // namespace animado::bench
