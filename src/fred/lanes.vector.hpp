// A register of doubles. For sources that are compiled once for each instruction set: no standard header is
// included, and everything has internal linkage, because an inline function compiled here for AVX2 must not
// become the copy that the linker keeps for the whole program.
#pragma once

#include <stddef.h>

namespace animado::fred {
namespace {

constexpr size_t kWidth = ANIMADO_LANE_BYTES / sizeof(double);

#if ANIMADO_LANE_BYTES == 8
using Lane = double;
using UnalignedLane = double;
#else
using Lane = double __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using UnalignedLane = double __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));
#endif

#define ANIMADO_INLINE [[gnu::always_inline]] inline

ANIMADO_INLINE Lane at(const double* p, size_t element) {
  return *reinterpret_cast<const UnalignedLane*>(p + element);
}

ANIMADO_INLINE void put(double* p, size_t element, Lane lane) {
  *reinterpret_cast<UnalignedLane*>(p + element) = lane;
}

}  // namespace
}  // namespace animado::fred
