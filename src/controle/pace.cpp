#include "controle/pace.hpp"

#include <poll.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace animado::controle {
namespace {

constexpr double kLongestWait_s = 0.2;  // at a time: so late a signal is noticed that just misses a wait

}  // namespace

Pace::Pace(int descriptor, std::function<bool()> stop)
    : descriptor_(descriptor), stop_(std::move(stop)), commands_(descriptor) {}

void Pace::wait(double time_s) {
  for (;;) {
    take_commands(time_s);
    if (!open_ || stop_()) return;
    double wait_s = kLongestWait_s;
    if (paused_) {
      if (steps_ > 0) {
        --steps_;
        return;
      }
    } else {
      if (speed_ == 0) return;
      const std::chrono::duration<double> passed = Clock::now() - since_;
      const double left_s = (time_s - since_time_s_) / speed_ - passed.count();
      if (left_s <= 0) return;
      wait_s = std::min(left_s, kLongestWait_s);
    }
    pollfd command{descriptor_, POLLIN, 0};
    poll(&command, 1, static_cast<int>(std::ceil(wait_s * 1000)));
  }
}

void Pace::take_commands(double time_s) {
  open_ = open_ && commands_.read_lines([&](const std::string& command) { take(command, time_s); });
}

void Pace::take(const std::string& command, double time_s) {
  start_again(time_s);
  if (command == "pause") {
    paused_ = true;
    steps_ = 0;
  } else if (command == "resume") {
    paused_ = false;
  } else if (command == "step") {
    paused_ = true;
    ++steps_;
  } else if (command.starts_with("speed ")) {
    speed_ = std::max(0.0, std::strtod(command.c_str() + 6, nullptr));
  }
}

void Pace::start_again(double time_s) {
  since_ = Clock::now();
  since_time_s_ = time_s;
}

}  // namespace animado::controle
