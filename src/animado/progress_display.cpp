#include "animado/progress_display.hpp"

#include <algorithm>

#include "animado/terminal.hpp"

namespace animado {

namespace {

constexpr std::chrono::milliseconds kRedraw{100};  // faster than that nobody reads
constexpr std::chrono::seconds kBetweenLines{1};   // a log of a short run stays short
constexpr int kBarWidth = 20;

std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

int64_t tenth(const controle::Progress& progress) {
  return progress.frames > 0 ? 10 * progress.frame / progress.frames : 0;
}

}  // namespace

std::string progress_text(const controle::Progress& progress, double elapsed_s) {
  const double part =
      progress.frames > 0 ? static_cast<double>(progress.frame) / static_cast<double>(progress.frames) : 0;
  const int filled = static_cast<int>(part * kBarWidth);
  std::string text = fmt::format("[{:<{}}] frame {} of {}, t = {:.4g} s, {} {}, {} {}",
                                 std::string(filled, '='), kBarWidth, progress.frame, progress.frames,
                                 progress.time_s, progress.bodies, progress.bodies == 1 ? "body" : "bodies",
                                 progress.contacts, progress.contacts == 1 ? "contact" : "contacts");
  if (elapsed_s <= 0 || part <= 0) return text;
  text += fmt::format(", {:.0f} steps/s", static_cast<double>(progress.steps) / elapsed_s);
  if (part < 1) text += fmt::format(", {} left", duration_text(elapsed_s / part * (1 - part)));
  return text;
}

void ProgressDisplay::show(const controle::Progress& progress, Time now) {
  if (style_ == Style::silent) return;
  const auto pause = style_ == Style::terminal ? std::chrono::milliseconds(kRedraw)
                                               : std::chrono::milliseconds(kBetweenLines);
  if (now - last_shown_.value_or(style_ == Style::terminal ? Time{} : begin_) < pause) return;
  if (style_ == Style::lines && tenth(progress) == last_tenth_) return;

  std::string text = progress_text(progress, std::chrono::duration<double>(now - begin_).count());
  // \r goes to the line's start, ESC[K erases what is left of the line before.
  const bool terminal = style_ == Style::terminal;
  // A line that the terminal breaks is not written over.
  if (const auto size = terminal ? terminal_size(fileno(out_)) : std::nullopt)
    text.resize(std::min(text.size(), static_cast<size_t>(size->columns) - 1));
  fmt::print(out_, "{}{}{}", terminal ? "\r" : "", text, terminal ? "\x1b[K" : "\n");
  std::fflush(out_);
  last_shown_ = now;
  last_tenth_ = tenth(progress);
}

void ProgressDisplay::clear() {
  if (style_ != Style::terminal || !last_shown_) return;
  fmt::print(out_, "\r\x1b[K");
  std::fflush(out_);
  last_shown_.reset();
}

}  // namespace animado
