// The systems in one register as the kernels hold them, and the way up, which is the same for all.
#pragma once

#include "egesp/lanes.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// A beside B, by columns. N, M: the size where it is known when compiling, else 0.
template <int N, int M>
struct Block {
  static constexpr int kSpareRows = N ? 0 : 3;  // see lanes.looped.hpp
  static constexpr int kRows = (N ? N : kLaneSize) + kSpareRows;
  static constexpr int kColumns = N ? N + M : 2 * kLaneSize;

  Block(int n, int m) : given_n(n), given_m(m) {}
  ANIMADO_INLINE int n() const { return N ? N : given_n; }
  ANIMADO_INLINE int m() const { return N ? M : given_m; }
  ANIMADO_INLINE int columns() const { return n() + m(); }
  ANIMADO_INLINE int column_stride() const { return n() + kSpareRows; }
  ANIMADO_INLINE Lane* column(int j) { return a + j * column_stride(); }
  ANIMADO_INLINE Mask accepted(double tolerance) const {
    return weakest > larger(largest * tolerance, Lane{} + kSmallestPivot);
  }

  int given_n, given_m;
  Lane a[kRows * kColumns];                    // below the diagonal it comes to hold the factors
  Lane inverse[kRows];                         // of the pivots
  Lane largest;                                // |a_ij| at the start
  Lane weakest;                                // pivot
  Lane row_order[kRows], column_order[kRows];  // which row of A stands at k, and which column
};

template <int N, int M>
ANIMADO_INLINE void number_order(Block<N, M>& block) {
  for (int k = 0; k < block.n(); ++k) block.row_order[k] = block.column_order[k] = Lane{} + k;
}

// Where the systems of a block come from: element e of the first of them lies at e · stride.
struct Source {
  const double *matrices, *right_sides;
  size_t stride;
};

// x_k ← b_k / a_kk; b_i ← b_i − a_ik x_k, for k = n−1 … 0. Returns a sum over the solution: finite only if
// all of it is.
template <int N, int M>
ANIMADO_INLINE Lane sweep_upward(Block<N, M>& block) {
  const int n = block.n();
  Lane sum = {};
  each<N>(n, block.columns(), [&](int j) {
    Lane* b = block.column(j);
    each<N>(0, n, [&](int from_last) {
      const int k = n - 1 - from_last;
      const Lane* a = block.column(k);
      b[k] *= block.inverse[k];
      sum += b[k];
      each<N>(0, k, [&](int i) { b[i] -= a[i] * b[k]; });
    });
  });
  return sum;
}

}  // namespace
}  // namespace animado::egesp
