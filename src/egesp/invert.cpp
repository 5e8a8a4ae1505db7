#include "egesp/invert.hpp"

#include <algorithm>

namespace animado::egesp {

Elimination invert(std::span<double> a, std::span<double> inverse, size_t n, const PivotRule& rule) {
  std::ranges::fill(inverse, 0.0);
  for (size_t i = 0; i < n; ++i) inverse[i * n + i] = 1;
  return gauss_jordan(a, inverse, n, n, rule);
}

}  // namespace animado::egesp
