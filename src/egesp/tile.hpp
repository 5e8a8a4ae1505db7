// The inner loop of everything blocked: C ← C − S V on a tile of C that stays in registers, where S are
// factors and V rows of pivots.
//
//   c_rx ← c_rx − s_rk v_kx,   k = 0, 1, …, depth − 1, each product and each difference rounded
//
// Without a fused multiply-add: the bits are those of a plain loop on every instruction set, and SSE2 has
// none. It costs up to half of the arithmetic's rate where the processor has one.
//
// Included only by sources that are compiled once for each instruction set, which is why everything has
// internal linkage and no standard header is included (see lanes.vector.hpp).
#pragma once

#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

#define ANIMADO_UNROLL _Pragma("GCC unroll 16")

constexpr size_t kRows = kWidth == 8 ? 8 : 4;  // of a tile; with 3 registers a row, all registers are used
constexpr size_t kVectors = 3;
constexpr size_t kPanel = 64;  // columns eliminated before the rest is touched: longer ones make the panel,
                               // which runs slower, a larger part; shorter ones read the rest more often
constexpr size_t kGroup = kRows * kPanel + 8;  // numbers of a group of rows; groups 4 KiB apart would share
                                               // cache sets

ANIMADO_INLINE double absolute(double v) {
  return __builtin_fabs(v);
}
ANIMADO_INLINE size_t smaller(size_t u, size_t v) {
  return u < v ? u : v;
}

// C: kRows × (Vectors registers), rows c_stride apart. S: column by column, kRows each. V: row by row.
template <size_t Vectors>
void subtract_tile(double* c, size_t c_stride, const double* s, const double* v, size_t depth) {
  Lane sum[kRows][Vectors];
  ANIMADO_UNROLL for (size_t r = 0; r < kRows; ++r) {
    ANIMADO_UNROLL for (size_t x = 0; x < Vectors; ++x) {
      sum[r][x] = load(c + r * c_stride + x * kWidth);
      __builtin_prefetch(c + (r + kRows) * c_stride + x * kWidth, 1);
    }
  }
  for (size_t k = 0; k < depth; ++k) {
    ANIMADO_UNROLL for (size_t r = 0; r < kRows; ++r) {
      ANIMADO_UNROLL for (size_t x = 0; x < Vectors; ++x) {
        sum[r][x] -= s[k * kRows + r] * load(v + (k * Vectors + x) * kWidth);
      }
    }
  }
  ANIMADO_UNROLL for (size_t r = 0; r < kRows; ++r) {
    ANIMADO_UNROLL for (size_t x = 0; x < Vectors; ++x) store(c + r * c_stride + x * kWidth, sum[r][x]);
  }
}

// The same where C has fewer rows or columns than a tile; S and V are filled up with zeros.
template <size_t Vectors>
void subtract_edge(double* c, size_t c_stride, size_t rows, size_t columns, const double* s, const double* v,
                   size_t depth) {
  constexpr size_t kColumns = Vectors * kWidth;
  double tile[2 * kRows * kColumns] = {};  // its second half is only prefetched
  for (size_t r = 0; r < rows; ++r) {
    for (size_t x = 0; x < columns; ++x) tile[r * kColumns + x] = c[r * c_stride + x];
  }
  subtract_tile<Vectors>(tile, kColumns, s, v, depth);
  for (size_t r = 0; r < rows; ++r) {
    for (size_t x = 0; x < columns; ++x) c[r * c_stride + x] = tile[r * kColumns + x];
  }
}

// C ← C − S V for groups of rows; row 0 of C is that of the first group.
template <size_t Vectors>
void subtract_groups(double* c, size_t c_stride, size_t rows, size_t columns, const double* s,
                     const double* v, size_t depth) {
  for (size_t r = 0; r < rows; r += kRows, s += kGroup) {
    if (rows - r >= kRows && columns == Vectors * kWidth) {
      subtract_tile<Vectors>(c + r * c_stride, c_stride, s, v, depth);
    } else {
      subtract_edge<Vectors>(c + r * c_stride, c_stride, smaller(kRows, rows - r), columns, s, v, depth);
    }
  }
}

// Calls work(first column, columns, registers) for one strip of columns after the other.
template <class Work>
ANIMADO_INLINE void for_each_strip(size_t columns, const Work& work) {
  for (size_t first = 0; first < columns;) {
    const size_t left = columns - first;
    if (left > 2 * kWidth) {
      work.template operator()<3>(first, smaller(left, 3 * kWidth));
    } else if (left > kWidth) {
      work.template operator()<2>(first, left);
    } else {
      work.template operator()<1>(first, left);
    }
    first += 3 * kWidth;
  }
}

}  // namespace
}  // namespace animado::egesp
