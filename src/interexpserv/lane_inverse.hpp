// asin, acos, atan, atan2.
//
//   atan x = atan b + atan t,  t = (x − b) / (1 + b x),  b one of 0, ½, 1, 3/2, ∞ so that |t| ≤ 7/16
//   asin x = x + x³ A(x²) for |x| ≤ ½, else π/2 − 2 asin √((1 − |x|)/2), the root as a sum of two numbers
//
// After [CW80, 9 and 10]; minimax polynomials, atan to 2^−57, asin to 2^−59. Largest errors in units of the
// last place: asin and acos 0.7, atan 0.8, atan2 1.52.
#pragma once

#include "interexpserv/lane.hpp"

namespace animado::interexpserv {
namespace {

constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;

// of a number that is not negative
ANIMADO_INLINE Lane angle_of(Lane a) {
  constexpr double c[] = {-0x1.555555555550cp-2, 0x1.999999998e9c3p-3,  -0x1.2492491ffd098p-3,
                          0x1.c71c6fde3ecbap-4,  -0x1.745cdbedd44f7p-4, 0x1.3b0f2476f6797p-4,
                          -0x1.10d626cf13afdp-4, 0x1.dddf5aa2c3071p-5,  -0x1.97a66f324cf31p-5,
                          0x1.2b234daa45c98p-5,  -0x1.0a920f107c40dp-6};
  Lane above = all(-1.0), below = a, base = all(kHalfPi), base_low = all(kHalfPiLow);
  const auto take = [&](double limit, Lane over, Lane under, double angle, double angle_low)
      __attribute__((always_inline)) {
    const Mask here = a < limit;
    above = select(here, over, above);
    below = select(here, under, below);
    base = select(here, all(angle), base);
    base_low = select(here, all(angle_low), base_low);
  };
  take(39.0 / 16, a - 1.5, 1.0 + 1.5 * a, 0x1.f730bd281f69bp-1, 0x1.007887af0cbbdp-56);
  take(19.0 / 16, a - 1.0, 1.0 + a, 0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55);
  take(11.0 / 16, 2.0 * a - 1.0, 2.0 + a, 0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56);
  take(7.0 / 16, a, all(1.0), 0, 0);
  const Lane t = above / below, z = t * t;
  return base + (t + (t * z * polynomial(c, z) + base_low));
}

ANIMADO_INLINE Lane arctangent(Lane x) {
  return flipped(angle_of(magnitude(x)), sign_of(x));
}

ANIMADO_INLINE Lane arctangent2(Lane y, Lane x) {
  constexpr double pi = 2 * kHalfPi, pi_low = 2 * kHalfPiLow;
  const Lane a = magnitude(y), b = magnitude(x);
  Lane slope = a / b;
  slope = select((a == kInfinity) & (b == kInfinity), all(1.0), slope);
  slope = select(a == 0.0, all(0.0), slope);
  const Lane angle = angle_of(slope);
  const Mask behind = -(Mask)((Word)x >> 63);
  const Lane result = select(behind, pi - (angle - pi_low), angle);
  return select(is_nan(x) | is_nan(y), x + y, flipped(result, sign_of(y)));
}

// asin x = root + root · bend for the reduced argument.
struct Arc {
  Lane root, low;  // |x|, or √((1 − |x|)/2)
  Lane bend;
  Mask outer;  // |x| > ½
};
ANIMADO_INLINE Arc arc_of(Lane x) {
  constexpr double c[] = {0x1.5555555555578p-3, 0x1.333333332df80p-4, 0x1.6db6db722602cp-5,
                          0x1.f1c71a8dc559ep-6, 0x1.6e8bdfa64b847p-6, 0x1.1c49e2bcd11bcp-6,
                          0x1.ca20cdfd8d265p-7, 0x1.757b7a5d527cbp-7, 0x1.6173f2539536bp-7,
                          0x1.e2bea79ad28f0p-9, 0x1.6492a42f6b548p-6, -0x1.59546dea5773fp-6,
                          0x1.0bb05ae4f4123p-5};
  const Lane a = magnitude(x);
  const Mask outer = a > 0.5;
  const Lane z = select(outer, (1.0 - a) * 0.5, a * a);
  const Lane root = select(outer, square_root(z), a);
  const Pair square = product(root, root);
  const Lane low = select(outer & (z > 0.0), ((z - square.high) - square.low) / (root + root), all(0.0));
  return {root, low, z * polynomial(c, z), outer};
}

ANIMADO_INLINE Lane arcsine(Lane x) {
  const Arc arc = arc_of(x);
  const Lane part = arc.root * arc.bend;
  const Lane inner = arc.root + part;
  const Pair near = sum(all(kHalfPi), -2.0 * arc.root);
  const Lane outer = near.high + (near.low + (kHalfPiLow - 2.0 * (part + arc.low)));
  return flipped(select(arc.outer, outer, inner), sign_of(x));
}

ANIMADO_INLINE Lane arccosine(Lane x) {
  const Arc arc = arc_of(x);
  const Lane part = arc.root * arc.bend;
  const Pair straight = sum(all(kHalfPi), -x);
  const Lane inner = straight.high + (straight.low + (kHalfPiLow - flipped(part, sign_of(x))));
  const Lane right = 2.0 * (arc.root + (part + arc.low));
  const Pair around = sum(all(2 * kHalfPi), -2.0 * arc.root);
  const Lane left = around.high + (around.low + (2 * kHalfPiLow - 2.0 * (part + arc.low)));
  return select(arc.outer, select(x > 0.0, right, left), inner);
}

}  // namespace
}  // namespace animado::interexpserv
