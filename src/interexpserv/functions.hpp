// The one list of operators and functions: name, types, what it is made of, and its line in
// docs/expressions.md (a test compares that page with this list).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interexpserv/builder.hpp"

namespace animado::interexpserv {

// What a function asks of the dimensions of its arguments, and what dimension it yields.
enum class Rule : uint8_t {
  any,       // nothing; plain
  same,      // all are the same, and so is the result
  compared,  // all are the same; a pure number or a boolean
  number,    // all are pure numbers or angles; so is the result
  product,
  quotient,
  root,  // square root
  cube_root,
  power,   // to a constant exponent; else both are pure numbers
  choice,  // the first is a condition, the others are the same
  first,   // that of the first
};

struct Function {
  std::string_view name;        // as in a postfix node: "sin", "+", "?:", ".x"; "-" of one value is the sign
  std::string_view parameters;  // a letter each: b boolean, s scalar, v vector, t text; a final '*' repeats
                                // the last as often as wanted
  Type result;
  Rule rule;
  Operand (*build)(Builder&, std::span<const Operand>);  // null: compile.cpp does it
  std::string_view doc;
};

std::span<const Function> functions();

// The row for these arguments, null when there is none.
const Function* find_function(std::string_view name, std::span<const Operand> arguments);
bool is_function(std::string_view name);

// The dimension of the result. Throws a message about the arguments that do not fit; plain ones do.
struct Misfit {
  std::string what, remedy;
};
Dimension dimension_of(const Function& function, const Builder& builder, std::span<const Operand> arguments);

// "(scalar, scalar)", "(scalar, scalar, …)"
std::string signature_of(const Function& function);

}  // namespace animado::interexpserv
