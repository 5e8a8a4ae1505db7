// sin, cos and tan.
//
// x = n π/2 + r, |r| ≤ π/4, with π/2 in three parts of 37, 36 and 53 bits, so that the first two multiples by
// an n of 16 bits are exact ([CW80, 8]); r is kept as a difference of two numbers. For |x| ≤ 10^5 this r is
// right to 2^−55 of itself: no double there is nearer to a multiple of π/2 than 2^−56. Beyond, each lane goes
// the slow and exact way of [PH83] and [NG92] (reduction.cpp).
//
//   sin r = r + r³ S(r²)      cos r = 1 − r²/2 + r⁴ C(r²)      minimax to 2^−58 and 2^−64
//
// Largest errors in units of the last place: sin and cos 0.87, tan 2.3.
#pragma once

#include "interexpserv/lane.hpp"
#include "interexpserv/lanes.hpp"

namespace animado::interexpserv {
namespace {

constexpr double kReduced = 1e5;  // larger arguments are reduced one by one

struct Reduced {
  Lane r, rest;   // the angle is r − rest
  Word quadrant;  // n, of which the two lowest bits are meant
};

ANIMADO_INLINE Reduced reduced(Lane x) {
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  constexpr double part1 = 0x1.921fb54440000p+0, part2 = 0x1.68c234c4c0000p-39, part3 = 0x1.98a2e03707345p-77;
  const Lane shifted = x * two_over_pi + kInteger, n = shifted - kInteger;
  const Lane first = x - n * part1, second = n * part2;
  const Lane r = first - second;
  return {r, n * part3 - ((first - r) - second), (Word)shifted};
}

// sin and cos of r − rest
struct Waves {
  Lane sine, cosine;
};
ANIMADO_INLINE Waves waves(Lane r, Lane rest) {
  constexpr double s[] = {-0x1.5555555555549p-3, 0x1.111111110f881p-7,   -0x1.a01a019c126afp-13,
                          0x1.71de357872ce2p-19, -0x1.ae5e66d2fabfap-26, 0x1.5d932e98affbep-33};
  constexpr double c[] = {0x1.555555555554cp-5,   -0x1.6c16c16c15184p-10, 0x1.a01a019cb270ap-16,
                          -0x1.27e4f80a773e7p-22, 0x1.1ee9ec4815971p-29,  -0x1.8faecf46ee884p-37};
  const Lane z = r * r, half = 0.5 * z, w = 1.0 - half;
  return {r + (r * z * polynomial(s, z) - rest * w),
          w + (((1.0 - w) - half) + (z * z * polynomial(c, z) + r * rest))};
}

// sin(n π/2 + r); a quarter turn more makes it the cosine.
ANIMADO_INLINE Lane turned(const Reduced& x, unsigned long long quarters) {
  const Word quadrant = x.quadrant + quarters;
  const Mask odd = -(Mask)(quadrant & 1);
  const Waves wave = waves(x.r, x.rest);
  return flipped(select(odd, wave.cosine, wave.sine), (quadrant & 2) << 62);
}

ANIMADO_INLINE Lane quotient(const Reduced& x) {
  const Waves wave = waves(x.r, x.rest);
  const Mask odd = -(Mask)(x.quadrant & 1);
  return select(odd, -wave.cosine, wave.sine) / select(odd, wave.sine, wave.cosine);
}

// The lanes that the quick way does not reach, one by one.
ANIMADO_INLINE Lane repaired(Lane x, Lane value, double (*slow)(double)) {
  const Mask beyond = ~(magnitude(x) <= kReduced);
  if (__builtin_expect(!any(beyond), 1)) return value;
  Lane mended = value;
  for (size_t i = 0; i < kWidth; ++i) {
    if (beyond[i]) mended[i] = slow(x[i]);
  }
  return mended;
}

// By |x|, so that −0 keeps its sign.
ANIMADO_INLINE Lane sine(Lane x) {
  return repaired(x, flipped(turned(reduced(magnitude(x)), 0), sign_of(x)), slow_sine);
}
ANIMADO_INLINE Lane cosine(Lane x) {
  return repaired(x, turned(reduced(x), 1), slow_cosine);
}
ANIMADO_INLINE Lane tangent(Lane x) {
  return repaired(x, flipped(quotient(reduced(magnitude(x))), sign_of(x)), slow_tangent);
}

}  // namespace
}  // namespace animado::interexpserv
