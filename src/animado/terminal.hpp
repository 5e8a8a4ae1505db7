// What people read: on stderr, in colour where that is wanted.
#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"

namespace animado {

bool stderr_is_terminal();

enum class Paint { bold, red, green, dim };
// With colour on a terminal, without it elsewhere or when NO_COLOR is set (no-color.org).
std::string painted(std::string_view text, Paint paint);

// "error: file:line:column: what was found", the remedy under it.
void print_error(const Error& error);
void print_note(std::string_view text);

}  // namespace animado
