#include "egesp/determinant.hpp"

#include <algorithm>
#include <cmath>

namespace animado::egesp {

double determinant(std::span<double> a, size_t n, const PivotRule& rule) {
  const Echelon echelon = reduce_to_echelon(a, n, n, {}, 0, rule);
  return echelon.pivots < n ? 0.0 : product_of_pivots(a, n, echelon);
}

// Fraction and exponent apart: the product of many pivots may leave the doubles on the way and come back.
double product_of_pivots(std::span<const double> reduced, size_t n, const Echelon& echelon) {
  double fraction = echelon.odd ? -1.0 : 1.0;
  int64_t exponent = 0;
  for (size_t k = 0; k < n; ++k) {
    int shift = 0;
    fraction = std::frexp(fraction * reduced[k * n + k], &shift);
    exponent += shift;
  }
  return std::ldexp(fraction, static_cast<int>(std::clamp<int64_t>(exponent, -5000, 5000)));
}

}  // namespace animado::egesp
