// Calls to the other modules: a line each in controle's log, one more where a step ends, and the time spent
// waiting for each module, by which the summary tells where a run's time went.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <string>
#include <string_view>

#include "rpc/log.hpp"

namespace animado::controle {

struct Share {
  int64_t messages = 0;
  double seconds = 0;
};

class Meter {
 public:
  // Lines go to `log`, marked with the run's name and a number that counts the calls.
  Meter(rpc::Log& log, std::string run) : log_(log), run_(std::move(run)) {}

  // Runs `call`, which sends `message` to `module`.
  template <class F>
  auto timed(std::string_view module, std::string_view message, F&& call) {
    const auto begin = std::chrono::steady_clock::now();
    auto result = call();
    book(module, message, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return result;
  }
  // The calls since the last such line made the step.
  void step_ended(int64_t step, double time_s) {
    if (!log_.enabled(rpc::LogLevel::info)) return;
    line_.clear();
    fmt::format_to(std::back_inserter(line_), "{}#{} step {} ends at {} s", run_, calls_, step, time_s);
    log_.write(rpc::LogLevel::info, line_);
  }
  const std::map<std::string, Share, std::less<>>& shares() const { return shares_; }

 private:
  void book(std::string_view module, std::string_view message, double seconds) {
    auto share = shares_.find(module);
    if (share == shares_.end()) share = shares_.emplace(module, Share{}).first;
    ++share->second.messages;
    share->second.seconds += seconds;
    if (!log_.enabled(rpc::LogLevel::info)) return;
    line_.clear();
    fmt::format_to(std::back_inserter(line_), "{}#{} to {}: {} {:.1f} µs", run_, ++calls_, module, message,
                   seconds * 1e6);
    log_.write(rpc::LogLevel::info, line_);
  }

  rpc::Log& log_;
  std::string run_, line_;
  int64_t calls_ = 0;
  std::map<std::string, Share, std::less<>> shares_;
};

}  // namespace animado::controle
