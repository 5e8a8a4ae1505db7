#include "console/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace animado {

namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool is_terminal(int descriptor) {
  return isatty(descriptor) == 1 && is_set("TERM") && std::string_view(std::getenv("TERM")) != "dumb";
}

bool shows_colours(int descriptor) {
  return is_terminal(descriptor) && !is_set("NO_COLOR");
}

std::optional<TerminalSize> terminal_size(int descriptor) {
  winsize window{};
  if (ioctl(descriptor, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) return std::nullopt;
  return TerminalSize{window.ws_col, window.ws_row};
}

std::string painted(std::string_view text, Paint paint) {
  if (!shows_colours(STDERR_FILENO)) return std::string(text);
  constexpr std::array kCodes = {"1", "31", "32", "2"};  // in the order of Paint
  return fmt::format("\x1b[{}m{}\x1b[0m", kCodes[static_cast<size_t>(paint)], text);
}

void print_text(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_error(const Error& error) {
  const std::string where = error.where().empty() ? "" : error.where() + ": ";
  print_note(fmt::format("{} {}{}", painted("error:", Paint::red), where, error.message()));
  if (!error.remedy().empty()) print_note("  " + error.remedy());
}

void print_note(std::string_view text) {
  print_text(std::string(text) + "\n");
}

}  // namespace animado
