// exp, log, log10 and powers.
//
//   e^x = 2^n e^r             n = ⌊x / ln 2⌉, r = x − n ln 2 in two parts, |r| ≤ ln 2 / 2
//   log x = k ln 2 + log m    x = m 2^k, √½ ≤ m < √2, f = m − 1, s = f / (2 + f)
//         log m = f − f²/2 + s (f²/2 + R),  R = s² (2/3 + 2/5 s² + …)
//   x^y = e^(y log x)         with log x to 2^−68, as a sum of two numbers
//
// The ways are those of [CW80]; the polynomials are minimax, found by Remez' exchange in
// 60 digits: e^r to 2^−58, R to 2^−59. Largest errors in units of the last place, against a 113-bit
// reference: exp 0.97, log 0.87, log10 0.51, x^y 0.97.
#pragma once

#include "interexpserv/lane.hpp"

namespace animado::interexpserv {
namespace {

constexpr double kLog2E = 0x1.71547652b82fep+0;
constexpr double kLn2High = 0x1.62e42fefa3800p-1;  // 42 bits: a multiple by an exponent is exact
constexpr double kLn2Low = 0x1.ef35793c76730p-45;

// e^(x + low), or half of it, for which x is not negative; |low| is at most a unit in the last place of x.
ANIMADO_INLINE Lane exponential(Lane x, Lane low = Lane{}, bool halved = false) {
  constexpr double c[] = {0x1.000000000000bp-1,  0x1.5555555555561p-3,  0x1.5555555550042p-5,
                          0x1.111111110d626p-7,  0x1.6c16c185a36bdp-10, 0x1.a01a01bae8fd2p-13,
                          0x1.a019969e827e0p-16, 0x1.71dddfbe1ae9bp-19, 0x1.28b03eede2e15p-22,
                          0x1.af859af5c2968p-26};
  const Lane shifted = x * kLog2E + kInteger, n = shifted - kInteger;
  const Lane high = x - n * kLn2High, rest = n * kLn2Low - low;
  const Lane r = high - rest;
  const Lane power = 1.0 + (high + (r * r * polynomial(c, r) - rest));
  const Lane exponent = halved ? n - 1.0 : n;
  // Where 2^n or the result is not normal; and where it is 0 or infinite, there `power` means nothing.
  if (__builtin_expect(any(~(magnitude(x) <= 708.0)), 0)) {
    const Lane outside = select(x > 711.0, all(kInfinity), scaled(power, exponent));
    return select(x < -746.0, all(0.0), outside);
  }
  return power * power_of_two(exponent);
}

// What a logarithm of 0, of a negative number, of infinity or NaN is, else `value`.
ANIMADO_INLINE Lane or_special_log(Lane x, Lane value) {
  const Lane special = select(x == 0.0, all(-kInfinity), select(x < 0.0, all(kNaN), x));
  return select((x > 0.0) & (x < kInfinity), value, special);
}

ANIMADO_INLINE Lane logarithm(Lane x) {
  constexpr double c[] = {0x1.5555555555592p-1, 0x1.999999997fdbap-2, 0x1.24924941f10edp-2,
                          0x1.c71c5209639dep-3, 0x1.74663ee92b594p-3, 0x1.39a1ba732d990p-3,
                          0x1.2f0567f79854ap-3};
  const Parts p = parted(x, 0x1.6a09e667f3bcdp-1);
  const Lane f = p.fraction - 1.0, s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
  const Lane tail = s * (half + z * polynomial(c, z)) + p.exponent * kLn2Low;
  return or_special_log(x, p.exponent * kLn2High - ((half - tail) - f));
}

// log x for a finite x > 0, to 2^−68 of it.
ANIMADO_INLINE Pair precise_logarithm(Lane x) {
  constexpr double c[] = {0x1.9999999999996p-2, 0x1.2492492493034p-2, 0x1.c71c71c58084fp-3,
                          0x1.745d183244f6cp-3, 0x1.3b1362b9c75ffp-3, 0x1.1120b50eb471dp-3,
                          0x1.de33887864ff0p-4, 0x1.eb10571f4e236p-4};
  constexpr double two_thirds = 0x1.5555555555555p-1, two_thirds_low = 0x1.5555555555555p-55;
  const Parts p = parted(x, 0x1.6a09e667f3bcdp-1);
  const Lane f = p.fraction - 1.0;
  const Pair divisor = sum(all(1.0), p.fraction);
  const Lane s = f / divisor.high;
  const Pair back = product(s, divisor.high);
  const Lane s_low = (((f - back.high) - back.low) - s * divisor.low) / divisor.high;
  Pair z = product(s, s);
  z.low += 2.0 * s * s_low;
  Pair w = product(z.high, all(two_thirds));
  w.low += z.high * two_thirds_low + z.low * two_thirds;
  const Pair series = sum(w.high, z.high * z.high * polynomial(c, z.high));
  Pair tail = product(s, series.high);
  tail.low += s * (series.low + w.low) + s_low * series.high;
  const Pair of_fraction = sum(2.0 * s, tail.high);
  const Pair whole = sum(p.exponent * kLn2High, of_fraction.high);
  return sum(whole.high, whole.low + (of_fraction.low + tail.low + 2.0 * s_low + p.exponent * kLn2Low));
}

ANIMADO_INLINE Lane decimal_logarithm(Lane x) {
  constexpr double inverse = 0x1.bcb7b1526e50ep-2, inverse_low = 0x1.95355baaafad3p-57;  // 1 / ln 10
  const Pair natural = precise_logarithm(x);
  const Pair p = product(natural.high, all(inverse));
  return or_special_log(x, p.high + (p.low + (natural.low * inverse + natural.high * inverse_low)));
}

// As C says: x^0 and 1^y are 1 even for NaN; a negative base needs an integer for exponent.
ANIMADO_INLINE Lane power(Lane x, Lane y) {
  const Lane base = magnitude(x), size = magnitude(y);
  const Lane cut = select(size > 0x1p66, flipped(all(0x1p66), sign_of(y)), y);  // as good as infinite
  const Pair log = precise_logarithm(base);
  const Pair p = product(log.high, cut);
  Lane result = exponential(p.high, p.low + log.low * cut);
  const Mask grows = y > 0.0;
  result = select(base == 0.0, select(grows, 0.0, kInfinity), result);
  result = select(base == kInfinity, select(grows, kInfinity, 0.0), result);
  const Lane half = size * 0.5;
  const Mask integer = (size >= 0x1p52) | ((size + 0x1p52) - 0x1p52 == size);
  const Mask odd = integer & (size < 0x1p53) & ((half + 0x1p52) - 0x1p52 != half);
  result = flipped(result, sign_of(x) & (Word)odd);
  result = select((x < 0.0) & (base < kInfinity) & ~integer, all(kNaN), result);
  result = select(is_nan(x) | is_nan(y), x + y, result);
  return select((x == 1.0) | (y == 0.0), all(1.0), result);
}

}  // namespace
}  // namespace animado::interexpserv
