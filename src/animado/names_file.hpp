// A snapshot of definitions as text that people read, edit and compare: a line `name = expression` each. What
// an expression needs of further lines is indented; # opens a comment line.
#pragma once

#include <string>
#include <string_view>

#include "interexpserv/protocol.hpp"

namespace animado {

std::string names_text(const interexpserv::Snapshot::Reply& snapshot);

// where: the file, for messages. Throws Error(syntax) with file:line.
interexpserv::Snapshot::Reply names_in(std::string_view text, const std::string& where);

}  // namespace animado
