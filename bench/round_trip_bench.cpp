// An empty call to a service beside 64 bytes thrown to and fro on a bare socket. Both ends of both wait in
// the same way: they look, yield the processor, look again for up to 50 µs, then block.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>

#include "rpc/common.hpp"
#include "services.hpp"

namespace animado::bench {
namespace {

using Message = std::array<char, 64>;

bool receive(int fd, Message& message) {
  const auto begin = std::chrono::steady_clock::now();
  while (true) {
    const ssize_t n = recv(fd, message.data(), message.size(), MSG_DONTWAIT);
    if (n == static_cast<ssize_t>(message.size())) return true;
    if (n == 0 || (n < 0 && errno != EAGAIN)) return false;
    if (std::chrono::steady_clock::now() - begin < std::chrono::microseconds(50)) {
      sched_yield();
    } else {
      pollfd waiting{fd, POLLIN, 0};
      poll(&waiting, 1, -1);
    }
  }
}

void RoundTripRaw(benchmark::State& state) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return state.SkipWithError("no socket pair");
  Message message{};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    while (receive(ends[1], message) && send(ends[1], message.data(), message.size(), 0) > 0) {
    }
    _exit(0);
  }
  close(ends[1]);
  for (auto _ : state) {
    if (send(ends[0], message.data(), message.size(), 0) < 0 || !receive(ends[0], message))
      state.SkipWithError("the peer is gone");
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
}

void RoundTripPing(benchmark::State& state) {
  suite::Services services;
  rpc::Channel& fred = services.suite().channel("fred");
  for (auto _ : state) fred.call<rpc::Ping>({});
}

BENCHMARK(RoundTripRaw)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(RoundTripPing)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace
}  // namespace animado::bench
