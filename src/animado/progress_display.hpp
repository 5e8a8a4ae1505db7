// How far a run is, on stderr: one line that is written over on a terminal; elsewhere a plain line now and
// then.
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

#include "controle/progress.hpp"

namespace animado {

// "[=====     ] frame 6 of 12, t = 1.5 s, 2 bodies, 1 contact, 1200 steps/s, 3 s left". elapsed_s: since the
// run began.
std::string progress_text(const controle::Progress& progress, double elapsed_s);

class ProgressDisplay {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class Style { silent, lines, terminal };

  ProgressDisplay(Style style, std::FILE* out, Time begin) : style_(style), out_(out), begin_(begin) {}
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const controle::Progress& progress, Time now);
  void clear();  // before anything else is written: takes the line off the terminal

 private:
  Style style_;
  std::FILE* out_;
  Time begin_;
  std::optional<Time> last_shown_;
  int64_t last_tenth_ = 0;
};

}  // namespace animado
