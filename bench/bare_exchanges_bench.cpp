// What the nine exchanges of a step take where nothing is said and nothing is done: the least that processes
// cost on this machine, to which step_bench.cpp's difference is put.
#include <benchmark/benchmark.h>
#include <sched.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <numeric>
#include <vector>

#include "rpc/one_core.hpp"

namespace animado::bench {
namespace {

// What client and server see of each other: how often the one has asked and the other answered, and for how
// long both passed over their numbers meanwhile, which is not the exchange's time.
struct Desk {
  std::atomic<int64_t> asked, answered, passing_ns;
};

// Reads its numbers once, as a handler does, so that what the kernel and the caches knew is gone; how long.
int64_t pass_over(const std::vector<double>& numbers) {
  const auto begin = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(std::accumulate(numbers.begin(), numbers.end(), 0.0));
  return std::chrono::nanoseconds(std::chrono::steady_clock::now() - begin).count();
}

[[noreturn]] void serve(Desk& desk, int bell, const std::vector<double>& numbers) {
  const int epoll = epoll_create1(0);
  epoll_event event{EPOLLIN | EPOLLET, {}};
  epoll_ctl(epoll, EPOLL_CTL_ADD, bell, &event);
  for (int64_t call = 1;; ++call) {
    while (desk.asked.load() < call) epoll_wait(epoll, &event, 1, -1);
    desk.passing_ns += pass_over(numbers);
    desk.answered = call;
  }
}

// Turns of a client with three servers on one core, in the order of a step by RK4: a bell there, which costs
// the kernel a call, and back the server falls asleep. The argument: bytes that each passes over at its turn.
void NineBareExchanges(benchmark::State& state) {
  const rpc::OneCore core;
  const std::vector<double> numbers(static_cast<size_t>(state.range(0)) / sizeof(double), 1.0);
  auto* const desks =
      static_cast<Desk*>(mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  std::array<int, 3> bells;
  std::array<pid_t, 3> servers;
  for (size_t s = 0; s < servers.size(); ++s) {
    bells[s] = eventfd(0, EFD_NONBLOCK);
    servers[s] = fork();
    if (servers[s] != 0) continue;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    serve(desks[s], bells[s], numbers);
  }
  std::array<int64_t, 3> calls{};
  const auto exchange = [&](size_t s) {
    const int64_t passing_ns = desks[s].passing_ns;
    const int64_t own_ns = pass_over(numbers);
    desks[s].asked = ++calls[s];
    eventfd_write(bells[s], 1);
    while (desks[s].answered.load() < calls[s]) sched_yield();
    return own_ns + desks[s].passing_ns - passing_ns;
  };
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    int64_t passing_ns = 0;
    for (int stage = 0; stage < 4; ++stage) passing_ns += exchange(0) + exchange(1);
    passing_ns += exchange(2);
    const auto all = std::chrono::steady_clock::now() - begin - std::chrono::nanoseconds(passing_ns);
    state.SetIterationTime(std::chrono::duration<double>(all).count());
  }
  for (size_t s = 0; s < servers.size(); ++s) {
    kill(servers[s], SIGKILL);
    waitpid(servers[s], nullptr, 0);
    close(bells[s]);
  }
  munmap(desks, 4096);
}

BENCHMARK(NineBareExchanges)->Arg(0)->Arg(1 << 20)->Unit(benchmark::kMicrosecond)->UseManualTime();

}  // namespace
}  // namespace animado::bench
