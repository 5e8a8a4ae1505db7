// Calls to the other modules, with the time spent waiting for each: the summary tells where a run's time
// went.
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "rpc/channel.hpp"

namespace animado::controle {

struct Share {
  int64_t messages = 0;
  double seconds = 0;
};

class Meter {
 public:
  // Runs `call` and books its time on `module`.
  template <class F>
  auto timed(const char* module, F&& call) {
    const auto begin = std::chrono::steady_clock::now();
    auto result = call();
    Share& share = shares_[module];
    ++share.messages;
    share.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }
  const std::map<std::string, Share>& shares() const { return shares_; }

 private:
  std::map<std::string, Share> shares_;
};

}  // namespace animado::controle
