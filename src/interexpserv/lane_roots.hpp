// Roots, hyperbolic functions, rounding.
//
//   cbrt x   t from a polynomial, then twice t + t (w/t² − t) / (2 t + w/t²), the second time from 26 bits of
//   t,
//            whose square is exact
//   sinh x   x + x³ P(x²) for |x| < 1, else (e^x − e^−x)/2;  cosh likewise;  tanh = sinh/cosh, 1 − 2/(e^2x +
//   1)
//
// Largest errors in units of the last place: cbrt 0.7, hypot 1.2, sinh 1.65, cosh 1.4, tanh 2.45.
#pragma once

#include "interexpserv/lane_exp.hpp"

namespace animado::interexpserv {
namespace {

ANIMADO_INLINE Lane cube_root(Lane x) {
  constexpr double c[] = {0x1.0392cf88cf234p-1, 0x1.6fb1d5167f6c8p-1, -0x1.33d3676892c0ep-2,
                          0x1.60a1108d2aa51p-4, -0x1.5b7785bf1c06cp-7};
  const Lane a = magnitude(x);
  const Parts p = parted(a, 1.0);
  const Lane third = nearest((p.exponent - 1.0) * (1.0 / 3)), rest = p.exponent - 3.0 * third;
  const Mask one = rest == 1.0, two = rest == 2.0;
  const Lane w = p.fraction * select(two, all(4.0), select(one, 2.0, 1.0));
  const Lane scale = select(two, all(0x1.965fea53d6e3dp+0), select(one, 0x1.428a2f98d728bp+0, 1.0));
  const auto better = [&](Lane t) __attribute__((always_inline)) {
    const Lane r = w / (t * t);
    return t + t * ((r - t) / (t + t + r));
  };
  const Lane rough = better(polynomial(c, p.fraction) * scale);
  const Lane root = better((Lane)((Word)rough & ~0x7ffffffull)) * power_of_two(third);
  return select((a > 0.0) & (a < kInfinity), flipped(root, sign_of(x)), x);
}

ANIMADO_INLINE Lane hypotenuse(Lane x, Lane y) {
  const Lane a = magnitude(x), b = magnitude(y), larger = select(a > b, a, b);
  const Mask huge = larger > 0x1p500, tiny = larger < 0x1p-450;
  const Lane scale = select(huge, all(0x1p-600), select(tiny, 0x1p600, 1.0));
  const Lane back = select(huge, all(0x1p600), select(tiny, 0x1p-600, 1.0));
  const Lane u = a * scale, v = b * scale;
  return select((a == kInfinity) | (b == kInfinity), all(kInfinity), square_root(u * u + v * v) * back);
}

// sinh x for |x| ≤ 1
ANIMADO_INLINE Lane small_sinh(Lane x) {
  constexpr double c[] = {0x1.5555555555556p-3,  0x1.11111111110a1p-7,  0x1.a01a01a0291fdp-13,
                          0x1.71de3a45f70b4p-19, 0x1.ae6467669e987p-26, 0x1.611a3a182f532p-33,
                          0x1.b4cf7b2c12433p-41};
  const Lane z = x * x;
  return x + x * z * polynomial(c, z);
}

ANIMADO_INLINE Lane hyperbolic_sine(Lane x) {
  const Lane a = magnitude(x), half = exponential(a, Lane{}, true);
  return select(a < 1.0, small_sinh(x), flipped(half - 0.25 / half, sign_of(x)));
}

ANIMADO_INLINE Lane hyperbolic_cosine(Lane x) {
  const Lane half = exponential(magnitude(x), Lane{}, true);
  return half + 0.25 / half;
}

ANIMADO_INLINE Lane hyperbolic_tangent(Lane x) {
  constexpr double c[] = {0x1.5555555555555p-5,  0x1.6c16c16c16f2dp-10, 0x1.a01a019f7df94p-16,
                          0x1.27e4fc697a69ap-22, 0x1.1eec039b17903p-29, 0x1.96250b4892912p-37};
  const Lane a = magnitude(x), z = x * x;
  const Lane near = small_sinh(x) / (1.0 + (0.5 * z + z * z * polynomial(c, z)));  // |x| < 0.625
  const Lane far = 1.0 - 2.0 / (exponential(a + a) + 1.0);
  return select(a < 0.625, near, flipped(far, sign_of(x)));
}

// The largest integer not above x, with the sign of x.
ANIMADO_INLINE Lane rounded_down(Lane x) {
  const Lane a = magnitude(x);
  const Lane near = flipped((a + 0x1p52) - 0x1p52, sign_of(x));
  const Lane below = select(near > x, near - 1.0, near);
  return select(a < 0x1p52, below, x);
}
ANIMADO_INLINE Lane rounded_up(Lane x) {
  return -rounded_down(-x);
}
// Halves away from zero.
ANIMADO_INLINE Lane rounded(Lane x) {
  const Lane a = magnitude(x), whole = rounded_down(a);
  return select(a < 0x1p52, flipped(whole + select(a - whole >= 0.5, 1.0, 0.0), sign_of(x)), x);
}

}  // namespace
}  // namespace animado::interexpserv
