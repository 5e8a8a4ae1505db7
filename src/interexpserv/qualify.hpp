// A text that was written inside an object's block, as it reads outside it.
#pragma once

#include <string>
#include <string_view>

#include "interexpserv/scope.hpp"

namespace animado::interexpserv {

// The text, folded, with the prefix put before every name that means one of `home`: mass → ball.mass. Throws ExpressionError when the
// text cannot be cut into tokens.
std::string qualified(std::string_view text, const Scope& scope, std::string_view home);

}  // namespace animado::interexpserv
