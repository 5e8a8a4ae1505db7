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

// x_k ← b_k / a_kk; b_i ← b_i − a_ik x_k above it, for k = end − 1, … end − kCount: these unknowns first,
// then each b_i above is read and written once for all of them. Returns `sum` and what they add to it.
template <int kCount, int N, int M>
ANIMADO_INLINE Lane solve_unknowns(Block<N, M>& block, Lane* b, int end, Lane sum) {
  const Lane* a[kCount];
  Lane x[kCount];
#pragma GCC unroll 8
  for (int s = 0; s < kCount; ++s) {
    const int k = end - 1 - s;
    a[s] = block.column(k);
    x[s] = b[k];
#pragma GCC unroll 8
    for (int t = 0; t < s; ++t) x[s] -= a[t][k] * x[t];
    x[s] *= block.inverse[k];
    sum += x[s];
  }
#pragma GCC unroll 8
  for (int s = 0; s < kCount; ++s) b[end - 1 - s] = x[s];
  for (int i = end - kCount - 1; i >= 0; --i) {
    Lane v = b[i];
#pragma GCC unroll 8
    for (int s = 0; s < kCount; ++s) v -= a[s][i] * x[s];
    b[i] = v;
  }
  return sum;
}

// Returns a sum over the solution: finite only if all of it is.
template <int N, int M>
ANIMADO_INLINE Lane sweep_upward(Block<N, M>& block) {
  Lane sum = {};
  each<N>(block.n(), block.columns(), [&](int j) {
    int end = block.n();
    if constexpr (N > 0) {
      sum = solve_unknowns<N>(block, block.column(j), end, sum);
    } else {
      for (; end >= 4; end -= 4) sum = solve_unknowns<4>(block, block.column(j), end, sum);
      for (; end > 0; --end) sum = solve_unknowns<1>(block, block.column(j), end, sum);
    }
  });
  return sum;
}

}  // namespace
}  // namespace animado::egesp
