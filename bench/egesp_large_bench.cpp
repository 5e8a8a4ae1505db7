// Large systems: egesp's elimination in blocks beside Eigen's PartialPivLU and FullPivLU, its sparse factors
// beside KLU called directly, in-process and through the socket. `ratio` is our time over the peer's,
// `v3_ratio` over that of Eigen compiled for x86-64-v3 (AVX2 and fused multiply-add; ours needs neither and
// chooses its kernel when it runs), each the best of turns within a repetition.
#include <benchmark/benchmark.h>
#include <suitesparse/SuiteSparse_config.h>
#include <suitesparse/klu.h>

#include <Eigen/LU>
#include <chrono>
#include <cstdlib>

#include "egesp/client.hpp"
#include "egesp/gauss_jordan.hpp"
#include "egesp/lu.hpp"
#include "egesp/sparse_lu.hpp"
#include "eigen_v3.hpp"
#include "rpc/shared_array.hpp"
#include "services.hpp"

namespace animado::bench {
namespace {

using egesp::InstructionSet;

template <class Work>
double ms_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct Dense {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> a;
  Eigen::VectorXd b;

  explicit Dense(Eigen::Index n) {
    std::srand(12345);  // Eigen's Random draws from it
    a.setRandom(n, n);
    b.setRandom(n);
  }
  size_t n() const { return static_cast<size_t>(b.size()); }
  std::vector<double> matrix() const { return {a.data(), a.data() + a.size()}; }
  std::vector<double> side() const { return {b.data(), b.data() + b.size()}; }
  double backward_error(const std::vector<double>& solution) const {
    const Eigen::Map<const Eigen::VectorXd> x(solution.data(), b.size());
    return (b - a * x).lpNorm<Eigen::Infinity>() /
           (a.cwiseAbs().rowwise().sum().maxCoeff() * x.lpNorm<Eigen::Infinity>() +
            b.lpNorm<Eigen::Infinity>());
  }
};

enum class Way { gauss_jordan, lu, complete };

void solve(Way way, std::vector<double>& a, std::vector<double>& x, InstructionSet instructions) {
  if (way == Way::lu) {
    egesp::Lu(std::move(a), x.size(), {}, instructions).solve(x, 1);
  } else {
    egesp::gauss_jordan(a, x, x.size(), 1, {.complete = way == Way::complete}, instructions);
  }
}

void dense(benchmark::State& state, Way way) {
  const Dense system(state.range(0));
  const auto instructions = static_cast<InstructionSet>(state.range(1));
  if (instructions > egesp::widest_instruction_set()) return state.SkipWithError("not on this machine");
  state.SetLabel(std::array{"scalar", "SSE2", "AVX2", "AVX-512"}[static_cast<size_t>(instructions)]);
  const Eigen::MatrixXd columns = system.a;  // Eigen's own order
  double ours = HUGE_VAL, eigen = HUGE_VAL, eigen_v3 = HUGE_VAL;
  std::vector<double> x;
  for (auto _ : state) {
    std::vector<double> a = system.matrix();
    x = system.side();
    const double ms = ms_of([&] { solve(way, a, x, instructions); });
    state.SetIterationTime(ms * 1e-3);
    ours = std::min(ours, ms);
    Eigen::VectorXd y;
    eigen = std::min(eigen, ms_of([&] {
                       y = way == Way::complete ? Eigen::VectorXd(columns.fullPivLu().solve(system.b))
                                                : Eigen::VectorXd(columns.partialPivLu().solve(system.b));
                     }));
    benchmark::DoNotOptimize(y.data());
    if (way != Way::complete && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      eigen_v3 = std::min(
          eigen_v3, ms_of([&] { eigen_v3_solve(columns.data(), system.b.data(), y.data(), system.n()); }));
  }
  state.counters["ratio"] = ours / eigen;
  if (eigen_v3 < HUGE_VAL) state.counters["v3_ratio"] = ours / eigen_v3;
  state.counters["eigen_ms"] = eigen;
  state.counters["backward_error"] = system.backward_error(x);
}

const std::vector<int64_t> kSizes = {250, 1000}, kSets = {1, 2, 3};
BENCHMARK_CAPTURE(dense, gauss_jordan, Way::gauss_jordan)
    ->Name("egesp/dense/gauss_jordan")
    ->ArgsProduct({kSizes, kSets})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dense, lu, Way::lu)
    ->Name("egesp/dense/lu")
    ->ArgsProduct({kSizes, kSets})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dense, complete, Way::complete)
    ->Name("egesp/dense/complete")
    ->ArgsProduct({{1000}, {3}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// −Δ on a square of 300 × 300 points, as triplets.
struct Poisson {
  static constexpr int kSide = 300, kUnknowns = kSide * kSide;
  std::vector<double> rows, columns, values, b = std::vector<double>(kUnknowns, 1.0);

  Poisson() {
    const auto add = [&](int i, int j, double value) {
      rows.push_back(i), columns.push_back(j), values.push_back(value);
    };
    for (int i = 0; i < kUnknowns; ++i) {
      add(i, i, 4);
      if (i % kSide > 0) add(i, i - 1, -1);
      if (i % kSide < kSide - 1) add(i, i + 1, -1);
      if (i >= kSide) add(i, i - kSide, -1);
      if (i < kUnknowns - kSide) add(i, i + kSide, -1);
    }
  }
  egesp::SparseMatrix matrix() const {
    return egesp::SparsePattern(egesp::SparseFormat::triplets, kUnknowns, rows, columns, values.size())
        .matrix(values);
  }
};

// With the memory that it has by itself, not with that which egesp gives to it.
void solve_by_klu(egesp::SparseMatrix& a, std::vector<double>& x) {
  SuiteSparse_config.malloc_func = std::malloc;
  SuiteSparse_config.realloc_func = std::realloc;
  SuiteSparse_config.free_func = std::free;
  klu_common common;
  klu_defaults(&common);
  klu_symbolic* symbolic = klu_analyze(a.n, a.starts.data(), a.rows.data(), &common);
  klu_numeric* numeric = klu_factor(a.starts.data(), a.rows.data(), a.values.data(), symbolic, &common);
  klu_solve(symbolic, numeric, a.n, 1, x.data(), &common);
  klu_free_numeric(&numeric, &common);
  klu_free_symbolic(&symbolic, &common);
}

void beside_klu(benchmark::State& state, const Poisson& problem, const std::function<void()>& work) {
  egesp::SparseMatrix a = problem.matrix();
  double ours = HUGE_VAL, klu = HUGE_VAL;
  for (auto _ : state) {
    const double ms = ms_of(work);
    state.SetIterationTime(ms * 1e-3);
    ours = std::min(ours, ms);
    auto x = problem.b;
    klu = std::min(klu, ms_of([&] { solve_by_klu(a, x); }));
  }
  state.counters["ratio"] = ours / klu;
  state.counters["klu_ms"] = klu;
}

void sparse_library(benchmark::State& state) {
  const Poisson problem;
  const egesp::SparseMatrix a = problem.matrix();
  beside_klu(state, problem, [&] {
    auto x = problem.b;
    egesp::SparseLu(a, {}).solve(x, 1);
    benchmark::DoNotOptimize(x.data());
  });
}
BENCHMARK(sparse_library)
    ->Name("egesp/sparse/library")
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Triplets in, solution out: assembly counted, where KLU alone gets its compressed columns for nothing.
void sparse_socket(benchmark::State& state) {
  const Poisson problem;
  suite::Services services;
  rpc::SocketSuite& suite = services.suite();
  const auto share = [&](const std::string& name, const std::vector<double>& numbers) {
    const std::vector<int64_t> shape{static_cast<int64_t>(numbers.size())};
    std::ranges::copy(numbers, suite.arrays().create(name, shape).values().begin());
    return rpc::Array::named(name, shape);
  };
  egesp::SparseSolve::Request request;
  request.matrix = {egesp::Format::triplets, Poisson::kUnknowns, share("bench/rows", problem.rows),
                    share("bench/columns", problem.columns), share("bench/values", problem.values)};
  request.right_sides = share("bench/b", problem.b);
  request.out = share("bench/x", problem.b);
  egesp::Client client(suite.channel("egesp"));
  beside_klu(state, problem, [&] { client.sparse_solve(request); });
}
BENCHMARK(sparse_socket)
    ->Name("egesp/sparse/socket")
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace animado::bench
