// How fast a run goes while somebody watches it: commands that come on a descriptor, a line each.
//
//   pause           after this frame
//   resume
//   step            one frame more, and pause
//   speed S         simulated seconds a second; 0: as fast as it can (the default)
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "rpc/line_reader.hpp"

namespace animado::controle {

class Pace {
 public:
  // descriptor: does not block. stop: asked now and then while it waits.
  Pace(int descriptor, std::function<bool()> stop);

  // Called when a frame is written: returns when the next may begin. Who went away holds up nobody.
  void wait(double time_s);

 private:
  using Clock = std::chrono::steady_clock;

  void take_commands(double time_s);
  void take(const std::string& command, double time_s);
  void start_again(double time_s);  // the clock, from here

  int descriptor_;
  std::function<bool()> stop_;
  rpc::LineReader commands_;
  bool open_ = true, paused_ = false;
  double speed_ = 0;
  int64_t steps_ = 0;  // frames allowed while it is paused
  Clock::time_point since_ = Clock::now();
  double since_time_s_ = 0;
};

}  // namespace animado::controle
