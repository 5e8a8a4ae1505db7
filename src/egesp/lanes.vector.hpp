// A register of doubles, and the few operations that elimination is made of. For sources that are compiled
// once for each instruction set: no standard header is included, and everything has internal linkage, because
// an inline function compiled here for AVX-512 must not become the copy that the linker keeps for the whole
// program.
#pragma once

#include <stddef.h>

namespace animado::egesp {
namespace {

#define ANIMADO_INLINE [[gnu::always_inline]] inline

using Lane = double __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using Mask = long long __attribute__((vector_size(ANIMADO_LANE_BYTES)));  // a lane is −1 or 0
using UnalignedLane = double __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));
using UnalignedMask = long long __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));

constexpr size_t kWidth = ANIMADO_LANE_BYTES / sizeof(double);
constexpr double kSmallestPivot = 0x1p-1022;  // the reciprocal of less overflows
constexpr double kLargest = 0x1.fffffffffffffp1023;
constexpr long long kMagnitude = 0x7fffffffffffffff;

ANIMADO_INLINE Lane load(const double* p) {
  return *reinterpret_cast<const UnalignedLane*>(p);
}
ANIMADO_INLINE void store(double* p, Lane v) {
  *reinterpret_cast<UnalignedLane*>(p) = v;
}
ANIMADO_INLINE void store(long long* p, Mask v) {
  *reinterpret_cast<UnalignedMask*>(p) = v;
}
ANIMADO_INLINE Lane absolute(Lane v) {
  return (Lane)((Mask)v & kMagnitude);
}
ANIMADO_INLINE Lane with_sign(Lane v, Lane sign) {
  return (Lane)((Mask)v | ((Mask)sign & ~kMagnitude));
}
ANIMADO_INLINE Lane smaller(Lane u, Lane v) {
  return u < v ? u : v;
}
ANIMADO_INLINE bool finite(Lane v) {
  const Mask good = absolute(v) <= kLargest;
  long long all = -1;
  for (size_t lane = 0; lane < kWidth; ++lane) all &= good[lane];
  return all != 0;
}

// Hidden from the compiler, which would make branches (SSE2), blends of three steps (AVX2), or moves between
// two kinds of registers (AVX-512) of a mask that it sees through.
ANIMADO_INLINE Mask equal(Lane u, Lane v) {
  Mask mask = u == v;
  asm("" : "+v"(mask));
  return mask;
}

ANIMADO_INLINE Lane larger(Lane u, Lane v) {
#if ANIMADO_LANE_BYTES == 64
  return __builtin_ia32_maxpd512_mask(u, v, v, 0xff, 4);
#else
  return u > v ? u : v;
#endif
}

// What `row` becomes when it changes places, in the lanes of `here`, with the row that held `old`. `top` is
// what stands there, `old` at first: a lane changes places with one row at most.
ANIMADO_INLINE Lane exchanged(Mask here, Lane row, Lane old, Lane& top) {
#if ANIMADO_LANE_BYTES == 64
  constexpr int kSecondWhereThird = 0xD8;  // truth table of (third ? second : first)
  top = (Lane)__builtin_ia32_pternlogq512_mask((Mask)top, (Mask)row, here, kSecondWhereThird, 0xff);
  return (Lane)__builtin_ia32_pternlogq512_mask((Mask)row, (Mask)old, here, kSecondWhereThird, 0xff);
#else
  const Mask difference = ((Mask)row ^ (Mask)old) & here;
  top = (Lane)((Mask)top ^ difference);
  return (Lane)((Mask)row ^ difference);
#endif
}

// One number from, or to, a place of its own in each lane.
using Places = ptrdiff_t[kWidth];
ANIMADO_INLINE Lane gather(const double* numbers, const Places& at) {
#if ANIMADO_LANE_BYTES == 64
  return Lane{numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]],
              numbers[at[4]], numbers[at[5]], numbers[at[6]], numbers[at[7]]};
#elif ANIMADO_LANE_BYTES == 32
  return Lane{numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]]};
#else
  return Lane{numbers[at[0]], numbers[at[1]]};
#endif
}
ANIMADO_INLINE void scatter(Lane v, double* numbers, const Places& at) {
#pragma GCC unroll 8
  for (size_t lane = 0; lane < kWidth; ++lane) numbers[at[lane]] = v[lane];
}

// f(begin) … f(end − 1), unrolled where the size N is known when compiling: it is small, so that the code of
// a kernel stays in the instruction cache.
template <int N, class F>
ANIMADO_INLINE void each(int begin, int end, const F& f) {
  if constexpr (N > 0) {
#pragma GCC unroll 8
    for (int i = begin; i < end; ++i) f(i);
  } else {
    for (int i = begin; i < end; ++i) f(i);
  }
}

// work.operator()<count>(): loops of that many turns have no branch.
template <int kMost, class Work>
ANIMADO_INLINE void unrolled(int count, const Work& work) {
  if constexpr (kMost > 0) {
    if (count < kMost) return unrolled<kMost - 1>(count, work);
  }
  work.template operator()<kMost>();
}

}  // namespace
}  // namespace animado::egesp
