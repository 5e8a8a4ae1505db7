// Several numbers side by side, one a lane of a vector register, and the few operations that the functions of
// the language are made of. Every one of them is exact or rounded once, so that a formula has the same bits
// in each lane whatever the width; nothing here comes from the C library.
//
// These headers are compiled once for each instruction set. All of it has internal linkage and no standard
// header is included: an inline function compiled for AVX-512 must not become the copy that the linker keeps.
#pragma once

#include <stddef.h>

#ifndef ANIMADO_LANE_BYTES
#define ANIMADO_LANE_BYTES 8  // one number: plain scalar code
#endif

namespace animado::interexpserv {
namespace {

using Lane = double __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using Mask = long long __attribute__((vector_size(ANIMADO_LANE_BYTES)));  // all bits of a lane, or none
using Word = unsigned long long __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using UnalignedLane = double __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));

constexpr size_t kWidth = ANIMADO_LANE_BYTES / sizeof(double);
constexpr unsigned long long kSignBit = 0x8000000000000000;
constexpr double kInfinity = __builtin_inf(), kNaN = __builtin_nan("");
constexpr double kInteger =
    0x1.8p52;  // added to a number below 2^51 it leaves the nearest integer in the low bits

#define ANIMADO_INLINE [[gnu::always_inline, maybe_unused]] inline

ANIMADO_INLINE Lane load(const double* p) {
  return *reinterpret_cast<const UnalignedLane*>(p);
}
ANIMADO_INLINE void store(double* p, Lane v) {
  *reinterpret_cast<UnalignedLane*>(p) = v;
}
ANIMADO_INLINE Lane all(double x) {
  return x - Lane{};
}
ANIMADO_INLINE Lane select(Mask mask, Lane yes, Lane no) {
#if ANIMADO_LANE_BYTES == 16  // without an instruction for it; the compiler would compare the mask with 0
  return (Lane)(((Word)yes & (Word)mask) | ((Word)no & ~(Word)mask));
#else
  return mask ? yes : no;
#endif
}
ANIMADO_INLINE Lane select(Mask mask, double yes, double no) {
  return select(mask, all(yes), all(no));
}
ANIMADO_INLINE Lane magnitude(Lane x) {
  return (Lane)((Word)x & ~kSignBit);
}
ANIMADO_INLINE Word sign_of(Lane x) {
  return (Word)x & kSignBit;
}
ANIMADO_INLINE Lane flipped(Lane x, Word sign) {
  return (Lane)((Word)x ^ sign);
}
ANIMADO_INLINE Mask is_nan(Lane x) {
  return x != x;
}
ANIMADO_INLINE Lane truth(Mask mask) {
  return select(mask, 1.0, 0.0);
}

#if ANIMADO_LANE_BYTES == 64
ANIMADO_INLINE bool any(Mask mask) {
  return __builtin_ia32_cvtq2mask512(mask) != 0;
}
ANIMADO_INLINE Lane square_root(Lane x) {
#ifdef __clang__
  return __builtin_ia32_sqrtpd512(x, 4);
#else
  return __builtin_ia32_sqrtpd512_mask(x, x, static_cast<unsigned char>(-1), 4);
#endif
}
#elif ANIMADO_LANE_BYTES == 32
ANIMADO_INLINE bool any(Mask mask) {
  return __builtin_ia32_movmskpd256((Lane)mask) != 0;
}
ANIMADO_INLINE Lane square_root(Lane x) {
  return __builtin_ia32_sqrtpd256(x);
}
#elif ANIMADO_LANE_BYTES == 16
ANIMADO_INLINE bool any(Mask mask) {
  return __builtin_ia32_movmskpd((Lane)mask) != 0;
}
ANIMADO_INLINE Lane square_root(Lane x) {
  return __builtin_ia32_sqrtpd(x);
}
#else
ANIMADO_INLINE bool any(Mask mask) {
  return mask[0] != 0;
}
ANIMADO_INLINE Lane square_root(Lane x) {
  return Lane{__builtin_sqrt(x[0])};
}
#endif

// The nearest integer, halves to even; |x| < 2^51.
ANIMADO_INLINE Lane nearest(Lane x) {
  return (x + kInteger) - kInteger;
}

// 2^n for an integer n of −1022 … 1023.
ANIMADO_INLINE Lane power_of_two(Lane n) {
  return (Lane)((Word)(n + (kInteger + 1023)) << 52);
}

// x 2^n, rounded once more where it becomes subnormal; |n| ≤ 2000.
ANIMADO_INLINE Lane scaled(Lane x, Lane n) {
  const Lane half = nearest(n * 0.5);
  return x * power_of_two(half) * power_of_two(n - half);
}

// x = fraction · 2^exponent with `least` ≤ fraction < 2 least, for a finite x > 0.
struct Parts {
  Lane fraction, exponent;
};
ANIMADO_INLINE Parts parted(Lane x, double least) {
  const unsigned long long one = 0x3ff0000000000000, base = __builtin_bit_cast(unsigned long long, least);
  const Mask subnormal = x < 0x1p-1022;
  const Word bits = (Word)select(subnormal, x * 0x1p54, x) + (one - base);
  const Lane exponent = (Lane)((bits >> 52) | 0x4330000000000000ull) - (0x1p52 + 1023);
  return {(Lane)((bits & 0xfffffffffffffull) + base), exponent - select(subnormal, 54.0, 0.0)};
}

// Σ c[i] x^i, by halves: half as long a wait as Horner's rule.
template <size_t n>
ANIMADO_INLINE Lane joined(const Lane (&term)[n], Lane x) {
  if constexpr (n == 1) {
    return term[0];
  } else {
    Lane pair[(n + 1) / 2];
    for (size_t i = 0; i < n / 2; ++i) pair[i] = term[2 * i] + term[2 * i + 1] * x;
    if constexpr (n % 2 == 1) pair[n / 2] = term[n - 1];
    return joined(pair, x * x);
  }
}
template <size_t n>
ANIMADO_INLINE Lane polynomial(const double (&c)[n], Lane x) {
  Lane pair[(n + 1) / 2];
  for (size_t i = 0; i < n / 2; ++i) pair[i] = c[2 * i] + c[2 * i + 1] * x;
  if constexpr (n % 2 == 1) pair[n / 2] = all(c[n - 1]);
  return joined(pair, x * x);
}

// An unevaluated sum, |low| at most half a unit in the last place of high.
struct Pair {
  Lane high, low;
};

// a + b where |a| ≥ |b| or a is 0, exactly.
ANIMADO_INLINE Pair sum(Lane a, Lane b) {
  const Lane high = a + b;
  return {high, b - (high - a)};
}

// a b to 2^−105 of it: the factors are cut into halves whose products are exact ([DEK71]).
ANIMADO_INLINE Pair product(Lane a, Lane b) {
  const unsigned long long upper = ~0x7ffffffull;
  const Lane a1 = (Lane)((Word)a & upper), a2 = a - a1;
  const Lane b1 = (Lane)((Word)b & upper), b2 = b - b1;
  const Lane high = a * b;
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}

}  // namespace
}  // namespace animado::interexpserv
