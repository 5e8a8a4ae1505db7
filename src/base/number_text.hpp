// Numbers in messages.
#pragma once

#include <fmt/format.h>

#include <cmath>

namespace animado {

// As it can be read back. The sign of a NaN, which tells nothing, is left out.
inline std::string number_text(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

}  // namespace animado
