// What the way through the socket adds to a batch: 10,000 systems in shared arrays, solved by the service in
// its process, by the same service in this one, and by egesp's function alone, taking turns of kTurn batches.
// `ratio` is the first over the second, `to_function` over the third, of medians.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "animado/in_process.hpp"
#include "egesp/batch.hpp"
#include "egesp/client.hpp"
#include "rpc/one_core.hpp"
#include "rpc/shared_array.hpp"
#include "services.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::bench {
namespace {

constexpr int64_t kSystems = 10000;
constexpr int kTurn = 16;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> times) {
  std::ranges::nth_element(times, times.begin() + static_cast<ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

// Systems of n unknowns in arrays of a suite.
struct Systems {
  std::span<double> matrices, sides, solutions;
  egesp::Solve::Request request;

  Systems(rpc::Suite& suite, int64_t n) {
    const std::vector<int64_t> square{n, n, kSystems}, side{n, kSystems};
    std::srand(12345);
    request.matrices = rpc::Array::named("bench/matrices", square);
    request.right_sides = rpc::Array::named("bench/sides", side);
    request.out = rpc::Array::named("bench/solutions", side);
    matrices = share(suite, "bench/matrices", square);
    sides = share(suite, "bench/sides", side);
    solutions = share(suite, "bench/solutions", side);
    request.layout = egesp::Layout::lanes;
  }

 private:
  static std::span<double> share(rpc::Suite& suite, const std::string& name,
                                 const std::vector<int64_t>& shape) {
    const auto numbers = suite.arrays().create(name, shape).values();
    std::ranges::generate(numbers, [] { return 2.0 * std::rand() / RAND_MAX - 1; });
    return numbers;
  }
};

void batch_by_socket(benchmark::State& state) {
  const int64_t n = state.range(0);
  const rpc::OneCore core;  // as `animado run` starts the services
  suite::Services services;
  const TemporaryDirectory logs;  // as `animado run --in-process` keeps them
  const auto here = suite_in_process(logs.path());
  const Systems far(services.suite(), n), near(*here, n);
  egesp::Client to_far(services.suite().channel("egesp")), to_near(here->channel("egesp"));
  const egesp::Batch batch{near.matrices, near.sides, near.solutions, kSystems, static_cast<size_t>(n), 1,
                           true};

  std::vector<double> socket_s, in_process_s, function_s;
  for (auto _ : state) {
    double turn_s = 0;
    for (int i = 0; i < kTurn; ++i)
      turn_s += socket_s.emplace_back(seconds([&] { to_far.solve(far.request); }));
    for (int i = 0; i < kTurn; ++i) in_process_s.push_back(seconds([&] { to_near.solve(near.request); }));
    for (int i = 0; i < kTurn; ++i)
      function_s.push_back(seconds([&] { solve_batch(batch, {}, egesp::widest_instruction_set()); }));
    state.SetIterationTime(turn_s / kTurn);
  }
  state.counters["ratio"] = median(socket_s) / median(in_process_s);
  state.counters["to_function"] = median(socket_s) / median(function_s);
  state.counters["here_ns"] = median(in_process_s) * 1e9;
}
BENCHMARK(batch_by_socket)
    ->Name("egesp/socket")
    ->Arg(6)
    ->Arg(15)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace animado::bench
