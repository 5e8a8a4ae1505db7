#include "animado/terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace animado {

bool stderr_is_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

std::string painted(std::string_view text, Paint paint) {
  const char* no_color = std::getenv("NO_COLOR");
  if (!stderr_is_terminal() || (no_color != nullptr && *no_color != '\0')) return std::string(text);
  constexpr std::array kCodes = {"1", "31", "32", "2"};  // in the order of Paint
  return fmt::format("\x1b[{}m{}\x1b[0m", kCodes[static_cast<size_t>(paint)], text);
}

void print_error(const Error& error) {
  const std::string where = error.where().empty() ? "" : error.where() + ": ";
  fmt::print(stderr, "{} {}{}\n", painted("error:", Paint::red), where, error.message());
  if (!error.remedy().empty()) fmt::print(stderr, "  {}\n", error.remedy());
}

void print_note(std::string_view text) {
  fmt::print(stderr, "{}\n", text);
}

}  // namespace animado
