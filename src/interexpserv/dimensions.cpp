// What functions make of dimensions. Plain numbers, without a unit, fit everything; what is made of one and
// of something known is plain again in products, and known in sums.
#include <fmt/format.h>

#include "interexpserv/functions.hpp"

namespace animado::interexpserv {
namespace {

using Arguments = std::span<const Operand>;

Dimension common(std::string_view function, Arguments arguments) {
  Dimension found = kPlain;
  for (const Operand& argument : arguments) {
    const Dimension& dimension = argument.dimension;
    if (!dimension.known || dimension == found) continue;
    if (found.known) {
      throw Misfit{fmt::format("`{}` of {} and {}", function, text_of(found), text_of(dimension)),
                   "both have to measure the same; a number without a unit fits either, in SI"};
    }
    found = dimension;
  }
  return found;
}

void require_numbers(std::string_view function, Arguments arguments) {
  for (const Operand& argument : arguments) {
    if (!argument.dimension.known || argument.dimension.is_one()) continue;
    throw Misfit{fmt::format("`{}` of {}", function, text_of(argument.dimension)),
                 "a pure number or an angle is needed: divide by a value of that dimension"};
  }
}

Dimension power(const Function& function, const Builder& builder, Arguments arguments) {
  require_numbers(function.name, arguments.last(1));
  const Register exponent = arguments[1].at[0];
  if (builder.is_constant(exponent)) return to_power(arguments[0].dimension, builder.value(exponent));
  require_numbers(function.name, arguments);
  return kPlain;
}

}  // namespace

Dimension dimension_of(const Function& function, const Builder& builder, Arguments arguments) {
  switch (function.rule) {
    case Rule::any:
      return kPlain;
    case Rule::same:
      return common(function.name, arguments);
    case Rule::compared:
      common(function.name, arguments);
      return kPlain;
    case Rule::number:
      require_numbers(function.name, arguments);
      return kPlain;
    case Rule::product:
      return arguments[0].dimension * arguments[1].dimension;
    case Rule::quotient:
      return arguments[0].dimension / arguments[1].dimension;
    case Rule::root:
      return to_power(arguments[0].dimension, 0.5);
    case Rule::cube_root:
      return to_power(arguments[0].dimension, 1.0 / 3);
    case Rule::power:
      return power(function, builder, arguments);
    case Rule::choice:
      return common(function.name, arguments.subspan(1));
    case Rule::first:
      return arguments[0].dimension;
  }
  return kPlain;
}

}  // namespace animado::interexpserv
