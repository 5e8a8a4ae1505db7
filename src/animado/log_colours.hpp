// A line of a module's log (rpc/log.hpp) in colours: each module has its own, warnings and errors stand out.
#pragma once

#include <string>
#include <string_view>

namespace animado {

// The same text between ECMA-48 signs; a line of another form comes back as it is.
std::string coloured_log_line(std::string_view line);

}  // namespace animado
