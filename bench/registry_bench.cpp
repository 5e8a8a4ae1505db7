// INTEREXPSERV as a registry: what one client gets done in a second over the socket, one request after the
// other and pipelined, with and without a store; a hundred watchers; a million names. The peer is an empty
// call (RoundTripPing): what is above it is the registry's own.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "animado/child.hpp"
#include "interexpserv/client.hpp"
#include "interexpserv/names.hpp"
#include "interexpserv/store.hpp"
#include "rpc/socket_suite.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::bench {
namespace {

namespace fs = std::filesystem;
using namespace interexpserv;

constexpr int kNames = 1000;
constexpr int kBatch = 1000;

enum class Kept { in_memory, in_store };

// An interexpserv of its own, with some names.
class Registry {
 public:
  explicit Registry(Kept kept, const std::string& log_level = "info")
      : process_(words(folder_.path(), kept, log_level), folder_.path() / "output"), client_(suite_) {
    std::vector<Define::Definition> names;
    for (int i = 0; i < kNames; ++i) names.push_back({name(i), "1"});
    client_.define(names);
  }

  static std::string name(int i) { return fmt::format("body{}.mass", i % kNames); }
  rpc::SocketSuite connect() const {
    return rpc::SocketSuite({.directory = folder_.path(), .client = "bench", .trace = "bench"});
  }
  rpc::Channel& channel() { return suite_.channel("interexpserv"); }

 private:
  static std::vector<std::string> words(const fs::path& folder, Kept kept, const std::string& log_level) {
    std::vector<std::string> words = {std::string(ANIMADO_BENCH_PROGRAMS) + "/interexpserv", "--socket-dir",
                                      folder, "--log-level", log_level};
    if (kept == Kept::in_store) words.insert(words.end(), {"--store", folder / "names.sqlite"});
    return words;
  }

  TemporaryDirectory folder_;
  Child process_;
  rpc::SocketSuite suite_ = connect();
  Client client_;
};

void count_rate(benchmark::State& state, int64_t per_iteration) {
  state.counters["per_s"] = benchmark::Counter(static_cast<double>(state.iterations() * per_iteration),
                                               benchmark::Counter::kIsRate);
}

void RegistryGet(benchmark::State& state) {
  Registry registry(Kept::in_memory);
  int i = 0;
  for (auto _ : state) registry.channel().call<Get>({{Registry::name(++i)}, {}});
  count_rate(state, 1);
}

void RegistrySet(benchmark::State& state, Kept kept, const char* log_level) {
  Registry registry(kept, log_level);
  int i = 0;
  for (auto _ : state) registry.channel().call<Set>({Registry::name(++i), std::to_string(i), {}});
  count_rate(state, 1);
}

void RegistryGetPipelined(benchmark::State& state) {
  Registry registry(Kept::in_memory);
  std::vector<Get::Request> requests;
  for (int i = 0; i < kBatch; ++i) requests.push_back({{Registry::name(i)}, {}});
  for (auto _ : state) benchmark::DoNotOptimize(registry.channel().call_all<Get>(requests));
  count_rate(state, kBatch);
}

void RegistrySetPipelined(benchmark::State& state, Kept kept, const char* log_level) {
  Registry registry(kept, log_level);
  std::vector<Set::Request> requests;
  for (int i = 0; i < kBatch; ++i) requests.push_back({Registry::name(i), "0", {}});
  int value = 0;
  for (auto _ : state) {
    for (Set::Request& request : requests) request.text = std::to_string(++value);
    benchmark::DoNotOptimize(registry.channel().call_all<Set>(requests));
  }
  count_rate(state, kBatch);
}

// A batch of changes, and each watcher has read all of them.
void RegistryWatch(benchmark::State& state) {
  Registry registry(Kept::in_memory);
  std::vector<std::unique_ptr<rpc::SocketSuite>> watchers;
  for (int64_t i = 0; i < state.range(0); ++i) {
    watchers.push_back(std::make_unique<rpc::SocketSuite>(registry.connect()));
    Client(*watchers.back()).watch("body1.*");
  }
  constexpr int kChanges = 200;
  std::vector<Set::Request> requests(kChanges, {"body1.mass", "0", {}});
  int value = 1;  // what the names stand for already: to say the same is no change
  NameChanged::Request change;
  for (auto _ : state) {
    for (Set::Request& request : requests) request.text = std::to_string(++value);
    registry.channel().call_all<Set>(requests);
    for (auto& watcher : watchers) {
      Client client(*watcher);
      for (int i = 0; i < kChanges; ++i) {
        change = {};
        if (!client.wait_change(change, 10)) state.SkipWithError("a change was lost");
      }
    }
  }
  state.counters["changes_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations() * kChanges), benchmark::Counter::kIsRate);
  state.counters["delivered_per_s"] = benchmark::Counter(
      static_cast<double>(state.iterations() * kChanges * state.range(0)), benchmark::Counter::kIsRate);
}

// What a client notices of another one's changes, one for each hundred of its own requests, told to that many
// watchers.
void RegistryGetBesideWatchers(benchmark::State& state) {
  Registry registry(Kept::in_memory);
  constexpr size_t kRequestsAChange = 100;
  std::atomic<bool> over = false;
  std::atomic<int> changes_due = 0;
  std::thread others([&] {
    std::vector<std::unique_ptr<rpc::SocketSuite>> watchers;
    for (int64_t i = 0; i < state.range(0); ++i) {
      watchers.push_back(std::make_unique<rpc::SocketSuite>(registry.connect()));
      Client(*watchers.back()).watch("body1.*");
    }
    rpc::SocketSuite editing = registry.connect();
    Client editor(editing);
    NameChanged::Request change;
    for (int value = 0; !over; ++value) {
      editor.set("body1.mass", std::to_string(value));
      for (auto& watcher : watchers) Client(*watcher).wait_change(change = {}, 0);
      changes_due.wait(value);
    }
  });
  std::vector<double> times_us;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    registry.channel().call<Get>({{"body7.mass"}, {}});
    times_us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    if (times_us.size() % kRequestsAChange == 0) {
      ++changes_due;
      changes_due.notify_one();
    }
  }
  over = true;
  ++changes_due;
  changes_due.notify_one();
  others.join();
  const auto quantile = [&](double part) {
    const auto at =
        times_us.begin() + static_cast<ptrdiff_t>(part * static_cast<double>(times_us.size() - 1));
    std::nth_element(times_us.begin(), at, times_us.end());
    return *at;
  };
  state.counters["p50_us"] = quantile(0.5);
  state.counters["p99_us"] = quantile(0.99);
}

int64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  int64_t pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

void fill(Names& names, int count) {
  std::vector<NamedText> batch;
  for (int i = 0; i < count; ++i) {
    batch.push_back({fmt::format("body{}.mass", i), std::to_string(i)});
    if (batch.size() < kBatch) continue;
    names.define(batch, {.who = "bench"});
    batch.clear();
  }
}

// range(0) names, defined in transactions of a thousand, then read back from the file.
void RegistryManyNames(benchmark::State& state, Kept kept) {
  const auto count = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const TemporaryDirectory folder;
    const auto store =
        kept == Kept::in_store ? std::make_unique<Store>(folder.path() / "names.sqlite") : nullptr;
    const int64_t before = resident_bytes();
    Names names([&](std::span<const NamedRevision> revisions) {
      if (store) store->commit(revisions);
    });
    const auto begin = std::chrono::steady_clock::now();
    fill(names, count);
    const std::chrono::duration<double> filled = std::chrono::steady_clock::now() - begin;
    state.counters["define_us_each"] = 1e6 * filled.count() / count;
    if (!store) {
      state.counters["bytes_each"] = static_cast<double>(resident_bytes() - before) / count;
      continue;
    }
    const auto load_begin = std::chrono::steady_clock::now();
    Names again;
    again.load(store->load());
    const std::chrono::duration<double> loaded = std::chrono::steady_clock::now() - load_begin;
    state.counters["load_s"] = loaded.count();
  }
}

BENCHMARK(RegistryGet)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(RegistrySet, memory, Kept::in_memory, "info")->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(RegistrySet, store, Kept::in_store, "info")->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(RegistrySet, store_no_log, Kept::in_store, "warning")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(RegistryGetPipelined)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(RegistrySetPipelined, memory, Kept::in_memory, "info")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(RegistrySetPipelined, store, Kept::in_store, "info")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(RegistrySetPipelined, store_no_log, Kept::in_store, "warning")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(RegistryWatch)->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(RegistryGetBesideWatchers)->Arg(0)->Arg(100)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(RegistryManyNames, memory, Kept::in_memory)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RegistryManyNames, store, Kept::in_store)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace animado::bench
