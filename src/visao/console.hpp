// What people read while pictures are made, on stderr: plain lines in pipes and on dumb terminals.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "base/error.hpp"

namespace animado::visao {

void print_error(const Error& error);  // "error: where: what was found", the remedy under it

// "[=====     ] picture 40 of 300, 25 s left". elapsed_s: since the first was begun.
std::string progress_text(int64_t done, int64_t all, double elapsed_s);

// One line that is written over on a terminal; elsewhere a line at each tenth, at most one a second.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();  // takes the line off the terminal
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(int64_t done, int64_t all);

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, on_terminal_;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
  int64_t last_tenth_ = 0;
};

}  // namespace animado::visao
