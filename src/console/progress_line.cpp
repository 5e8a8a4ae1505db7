#include "console/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "console/terminal.hpp"

namespace animado {

namespace {

constexpr std::chrono::milliseconds kRedraw{100};         // faster than that nobody reads
constexpr std::chrono::milliseconds kBetweenLines{1000};  // a log of short work stays short
constexpr std::chrono::milliseconds kLongSilence{60000};  // after which work seems to have stopped
constexpr int kBarWidth = 20;

std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string progress_bar(double part) {
  return fmt::format("[{:<{}}]", std::string(static_cast<size_t>(part * kBarWidth), '='), kBarWidth);
}

std::string time_left(double part, double elapsed_s) {
  if (part <= 0 || part >= 1 || elapsed_s <= 0) return "";
  return fmt::format(", {} left", duration_text(elapsed_s / part * (1 - part)));
}

void ProgressLine::show(double part, Time now, const Text& text) {
  const int tenth = static_cast<int>(10 * part);
  if (style_ == Style::silent || !is_due(tenth, now)) return;
  std::string line = text(std::chrono::duration<double>(now - begin_).count());
  // \r goes to the line's start, ESC[K erases what is left of the line before.
  const bool terminal = style_ == Style::terminal;
  // A line that the terminal breaks is not written over.
  if (const auto size = terminal ? terminal_size(fileno(out_)) : std::nullopt)
    line.resize(std::min(line.size(), static_cast<size_t>(size->columns) - 1));
  // Not by fmt::print, which throws where the disk is full: the work goes on without this line.
  std::fputs(fmt::format("{}{}{}", terminal ? "\r" : "", line, terminal ? "\x1b[K" : "\n").c_str(), out_);
  std::fflush(out_);
  last_shown_ = now;
  last_tenth_ = tenth;
}

bool ProgressLine::is_due(int tenth, Time now) const {
  if (style_ == Style::terminal) return !last_shown_ || now - *last_shown_ >= kRedraw;
  const auto silence = now - last_shown_.value_or(begin_);
  return silence >= kLongSilence || (tenth != last_tenth_ && silence >= kBetweenLines);
}

void ProgressLine::clear() {
  if (style_ != Style::terminal || !last_shown_) return;
  std::fputs("\r\x1b[K", out_);
  std::fflush(out_);
  last_shown_.reset();
}

ProgressLine::Style progress_style(bool quiet) {
  if (quiet) return ProgressLine::Style::silent;
  return is_terminal(STDERR_FILENO) ? ProgressLine::Style::terminal : ProgressLine::Style::lines;
}

}  // namespace animado
