#include "visao/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace animado::visao {

namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool stderr_is_terminal() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

void print_error(const Error& error) {
  const bool in_color = stderr_is_terminal() && !is_set("NO_COLOR");
  const std::string where = error.where().empty() ? "" : error.where() + ": ";
  fmt::print(stderr, "{} {}{}\n", in_color ? "\x1b[31merror:\x1b[0m" : "error:", where, error.message());
  if (!error.remedy().empty()) fmt::print(stderr, "  {}\n", error.remedy());
}

std::string progress_text(int64_t done, int64_t all, double elapsed_s) {
  constexpr int kBarWidth = 20;
  const double part = static_cast<double>(done) / static_cast<double>(all);
  const std::string bar(static_cast<size_t>(part * kBarWidth), '=');
  std::string text = fmt::format("[{:<{}}] picture {} of {}", bar, kBarWidth, done, all);
  if (done == 0 || done == all) return text;
  const double left_s = elapsed_s / part * (1 - part);
  return text + (left_s < 60 ? fmt::format(", {:.0f} s left", left_s)
                             : fmt::format(", {:.0f} min left", left_s / 60));
}

Progress::Progress(bool quiet) : quiet_(quiet), on_terminal_(stderr_is_terminal()) {}

Progress::~Progress() {
  if (!quiet_ && on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(int64_t done, int64_t all) {
  if (quiet_) return;
  using namespace std::chrono_literals;
  const Clock::time_point now = Clock::now();
  const int64_t tenth = 10 * done / all;
  if (now - last_ < (on_terminal_ ? 100ms : 1000ms) || (!on_terminal_ && tenth == last_tenth_)) return;
  const std::string text = progress_text(done, all, std::chrono::duration<double>(now - begin_).count());
  fmt::print(stderr, "{}{}{}", on_terminal_ ? "\r" : "", text, on_terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
  last_ = now;
  last_tenth_ = tenth;
}

}  // namespace animado::visao
