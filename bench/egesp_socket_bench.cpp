// What the way through the socket adds to a batch: 10,000 systems in shared arrays, solved by the service
// and, taking turns of
// kTurn batches, in this process from the same arrays. `ratio` is the service's time over this process's,
// the medians of both.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "egesp/batch.hpp"
#include "egesp/client.hpp"
#include "rpc/one_core.hpp"
#include "rpc/shared_array.hpp"
#include "services.hpp"

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

void batch_by_socket(benchmark::State& state) {
  const int64_t n = state.range(0);
  const rpc::OneCore core;  // as `animado run` starts the services
  suite::Services services;
  rpc::SocketSuite& suite = services.suite();
  std::srand(12345);
  const auto share = [&](const std::string& name, const std::vector<int64_t>& shape) {
    const auto numbers = suite.arrays().create("bench/" + name, shape).values();
    std::ranges::generate(numbers, [] { return 2.0 * std::rand() / RAND_MAX - 1; });
    return numbers;
  };
  const std::vector<int64_t> square{n, n, kSystems}, side{n, kSystems};
  const auto matrices = share("matrices", square), sides = share("sides", side),
             solutions = share("solutions", side);
  egesp::Solve::Request request;
  request.matrices = rpc::Array::named("bench/matrices", square);
  request.right_sides = rpc::Array::named("bench/sides", side);
  request.out = rpc::Array::named("bench/solutions", side);
  request.layout = egesp::Layout::lanes;
  egesp::Client client(suite.channel("egesp"));
  const egesp::Batch batch{matrices, sides, solutions, kSystems, static_cast<size_t>(n), 1, true};

  std::vector<double> here, there;
  for (auto _ : state) {
    double turn_s = 0;
    for (int i = 0; i < kTurn; ++i) turn_s += there.emplace_back(seconds([&] { client.solve(request); }));
    for (int i = 0; i < kTurn; ++i)
      here.push_back(seconds([&] { solve_batch(batch, {}, egesp::widest_instruction_set()); }));
    state.SetIterationTime(turn_s / kTurn);
  }
  state.counters["ratio"] = median(there) / median(here);
  state.counters["here_ns"] = median(here) * 1e9;
}
BENCHMARK(batch_by_socket)
    ->Name("egesp/socket")
    ->Arg(6)
    ->Arg(15)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace animado::bench
