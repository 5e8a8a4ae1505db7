// Logarithm and power of two to three digits, as the length of a step needs them: a few additions and
// multiplications, which have the same bits on every processor. Those of libm may depend on whether it
// multiplies and adds at once.
#pragma once

#include <bit>
#include <cstdint>

namespace animado::fred {

// log2 x of a normal x > 0, to 0.01: between powers of two the parabola through both that is nearest.
inline double log2_near(double x) {
  const auto bits = std::bit_cast<int64_t>(x);
  const double m = std::bit_cast<double>((bits & 0xfffffffffffff) | 0x3ff0000000000000) - 1;
  return static_cast<double>((bits >> 52) - 1023) + m * (1.3465 - 0.3465 * m);
}

// 2^x to 0.35 %, likewise; |x| < 1000.
inline double exp2_near(double x) {
  const double above = x + 1023;  // positive, so that the cut is a floor
  const auto whole = static_cast<int64_t>(above);
  const double f = above - static_cast<double>(whole);
  return std::bit_cast<double>(whole << 52) * (1 + f * (0.6565 + 0.3435 * f));
}

}  // namespace animado::fred
