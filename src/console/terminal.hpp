// What people read: on stderr, in colour where that is wanted. What a terminal can do is asked here alone.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace animado {

bool is_terminal(int descriptor);    // one that moves its cursor as it is told: no pipe, no TERM=dumb
bool shows_colours(int descriptor);  // and NO_COLOR is not set (no-color.org)

struct TerminalSize {
  int columns, lines;
};
std::optional<TerminalSize> terminal_size(int descriptor);  // of one that knows its size

enum class Paint { bold, red, green, dim };
// In colour where stderr shows colours.
std::string painted(std::string_view text, Paint paint);

// To stderr, as it is. What does not arrive, on a full disk, is lost: there is nowhere else to tell of it.
void print_text(std::string_view text);
// "error: file:line:column: what was found", the remedy under it.
void print_error(const Error& error);
void print_note(std::string_view text);  // with an end of line

}  // namespace animado
