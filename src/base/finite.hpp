// Whether numbers are such as one can go on with.
#pragma once

#include <limits>
#include <span>

namespace animado {

// Whether |v| ≤ most for each of the numbers; NaN is within no bounds.
bool all_within(std::span<const double> numbers, double most);

inline bool all_finite(std::span<const double> numbers) {
  return all_within(numbers, std::numeric_limits<double>::max());
}

}  // namespace animado
