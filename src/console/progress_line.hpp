// How far long work is: one line that is written over on a terminal; elsewhere a plain line for each tenth of
// the work, and one a minute.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace animado {

// part: of the work, 0 … 1.
std::string progress_bar(double part);                 // "[=====     ]"
std::string time_left(double part, double elapsed_s);  // ", 3 s left"; empty where nobody knows

class ProgressLine {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class Style { silent, lines, terminal };
  // Asked for a text when one is due. elapsed_s: since the work began.
  using Text = std::function<std::string(double elapsed_s)>;

  ProgressLine(Style style, std::FILE* out, Time begin) : style_(style), out_(out), begin_(begin) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double part, Time now, const Text& text);
  void clear();  // before anything else is written: takes the line off the terminal

 private:
  bool is_due(int tenth, Time now) const;

  Style style_;
  std::FILE* out_;
  Time begin_;
  std::optional<Time> last_shown_;
  int last_tenth_ = 0;
};

ProgressLine::Style progress_style(bool quiet);  // as stderr is

}  // namespace animado
