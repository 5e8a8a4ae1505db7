// The one list of operators and functions: name, types, what it is made of, and its line in
// docs/expressions.md (a test compares that page with this list).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interexpserv/builder.hpp"

namespace animado::interexpserv {

struct Function {
  std::string_view name;        // as in a postfix node: "sin", "+", "?:", ".x"; "-" of one value is the sign
  std::string_view parameters;  // a letter each: b boolean, s scalar, v vector; a final '*' repeats the last
                                // as often as wanted
  Type result;
  Operand (*build)(Builder&, std::span<const Operand>);
  std::string_view doc;
};

std::span<const Function> functions();

// The row for these arguments, null when there is none.
const Function* find_function(std::string_view name, std::span<const Operand> arguments);
bool is_function(std::string_view name);

// "(scalar, scalar)", "(scalar, scalar, …)"
std::string signature_of(const Function& function);

}  // namespace animado::interexpserv
