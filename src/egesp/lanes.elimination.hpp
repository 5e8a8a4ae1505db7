// The downward sweep of Gauss–Jordan elimination for the systems in one register: the equations and the bits
// are those of echelon.hpp.
//
// Lanes with different pivots go the same way through the code: rows and columns change places under masks. A
// column is the unit of work: its rows lie side by side, so that a step takes each of them from memory once,
// brings the pivot up, and eliminates. The next column goes first: while the others follow, its pivot is
// looked for and divided by. The reciprocal is taken of the largest |a_ik|, which is known before its sign.
#pragma once

#include "egesp/lanes.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// Where the systems of a block come from: element e of the first of them lies at e · stride.
struct Source {
  const double *matrices, *right_sides;
  size_t stride;
};

// A beside B, by columns. N, M: the size where it is known when compiling, else 0.
template <int N, int M>
struct Block {
  static constexpr int kRows = N ? N : kLaneSize;
  static constexpr int kColumns = N ? N + M : 2 * kLaneSize;

  Block(int n, int m) : given_n(n), given_m(m) {}
  ANIMADO_INLINE int n() const { return N ? N : given_n; }
  ANIMADO_INLINE int m() const { return N ? M : given_m; }
  ANIMADO_INLINE int columns() const { return n() + m(); }
  ANIMADO_INLINE Lane* column(int j) { return a + j * n(); }
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

// Which rows (or columns) change places with the k-th, each in the lanes of its mask.
template <int N>
struct Choice {
  static constexpr int kRows = N ? N : kLaneSize;
  Mask here[kRows];
  int rows[kRows], count = 0;  // those that any lane chose; not kept where the size is known
};

template <int N, int M>
ANIMADO_INLINE void load_column(Block<N, M>& block, const Source& source, int j) {
  const int n = block.n();
  const bool left = j < n;
  const double* from = left ? source.matrices + static_cast<size_t>(j) * source.stride
                            : source.right_sides + static_cast<size_t>(j - n) * source.stride;
  const size_t row = source.stride * static_cast<size_t>(left ? n : block.m());
  Lane* c = block.column(j);
  each<N>(0, n, [&](int i) {
    const double* p = from + static_cast<size_t>(i) * row;
    // Each element is a stream of its own, and there are more of them than the processor follows by itself.
    __builtin_prefetch(p + 2 * kLaneGroup);
    c[i] = load(p);
  });
  if (!left) return;
  Lane largest = absolute(c[0]);
  each<N>(1, n, [&](int i) { largest = larger(absolute(c[i]), largest); });
  block.largest = j == 0 ? largest : larger(largest, block.largest);
}

// max size_i, i ≥ k, by halves where the size is known: the order changes no bit of a maximum and shortens
// the wait for it.
template <int N>
ANIMADO_INLINE Lane largest_of(const Lane* size, int k, int n) {
  if constexpr (N > 0) {
    Lane tree[N];
    each<N>(k, n, [&](int i) { tree[i] = size[i]; });
#pragma GCC unroll 8
    for (int step = 1; step < n - k; step *= 2) {
#pragma GCC unroll 8
      for (int i = k; i + step < n; i += 2 * step) tree[i] = larger(tree[i], tree[i + step]);
    }
    return tree[k];
  } else {
    Lane even = size[k], odd = {};
    for (int i = k + 1; i < n; i += 2) odd = larger(size[i], odd);
    for (int i = k + 2; i < n; i += 2) even = larger(size[i], even);
    return larger(even, odd);
  }
}

// The first whose size is the largest goes to k. One of them is, so the last is chosen where no other was.
template <int N>
ANIMADO_INLINE void choose(const Lane* size, int k, int n, Lane largest, Choice<N>& choice) {
  Mask taken = equal(size[k], largest);
  choice.count = 0;
  each<N>(k + 1, n, [&](int i) {
    const Mask candidate = i == n - 1 ? ~Mask{} : equal(size[i], largest);
    choice.here[i] = candidate & ~taken;
    taken |= candidate;
    if constexpr (N == 0) {
      choice.rows[choice.count] = i;
      choice.count += any(choice.here[i]);
    }
  });
}

// place(i): the i-th of what changes places.
template <int N, class Place>
ANIMADO_INLINE void change_places(const Choice<N>& choice, int k, int n, const Place& place) {
  const Lane old = place(k);
  Lane top = old;
  if constexpr (N > 0) {
    each<N>(k + 1, n, [&](int i) { place(i) = exchanged(choice.here[i], place(i), old, top); });
  } else {
    for (int c = 0; c < choice.count; ++c) {
      const int i = choice.rows[c];
      place(i) = exchanged(choice.here[i], place(i), old, top);
    }
  }
  place(k) = top;
}

template <int N>
ANIMADO_INLINE void change_rows(const Choice<N>& choice, int k, int n, Lane* column) {
  change_places<N>(choice, k, n, [&](int i) -> Lane& { return column[i]; });
}

// With the pivot in its place: column k becomes the factors.
template <int N, int M>
ANIMADO_INLINE void divide(Block<N, M>& block, int k, Lane pivot_size, Lane reciprocal) {
  Lane* a = block.column(k);
  block.weakest = k == 0 ? pivot_size : smaller(pivot_size, block.weakest);
  const Lane inverse = block.inverse[k] = with_sign(reciprocal, a[k]);
  each<N>(k + 1, block.n(), [&](int i) { a[i] *= inverse; });
}

template <int N, int M>
ANIMADO_INLINE void find_pivot(Block<N, M>& block, int k, Choice<N>& choice) {
  const int n = block.n();
  Lane* a = block.column(k);
  Lane size[Block<N, M>::kRows];
  each<N>(k, n, [&](int i) { size[i] = absolute(a[i]); });
  const Lane largest = largest_of<N>(size, k, n), reciprocal = 1.0 / largest;
  choose<N>(size, k, n, largest, choice);
  change_rows<N>(choice, k, n, a);
  divide(block, k, largest, reciprocal);
}

template <int N, int M>
ANIMADO_INLINE void subtract(Block<N, M>& block, int k, Lane* column) {
  const Lane* factor = block.column(k);
  const Lane top = column[k];
  each<N>(k + 1, block.n(), [&](int i) { column[i] -= factor[i] * top; });
}

// kKeep: the factors follow their rows, and row_order says which these are.
template <bool kKeep, int N, int M>
ANIMADO_INLINE void sweep_partial(Block<N, M>& block, const Source& source) {
  const int n = block.n(), columns = block.columns();
  Choice<N> choices[2];  // of this step and of the next
  load_column(block, source, 0);
  find_pivot(block, 0, choices[0]);
  each<N>(0, n, [&](int k) {
    const Choice<N>& choice = choices[k % 2];
    if constexpr (kKeep) {
      each<N>(0, k, [&](int j) { change_rows<N>(choice, k, n, block.column(j)); });
      change_rows<N>(choice, k, n, block.row_order);
    }
    const auto next = [&](int j) {
      Lane* column = block.column(j);
      if (k == 0) load_column(block, source, j);
      change_rows<N>(choice, k, n, column);
      subtract(block, k, column);
    };
    if (k + 1 < columns) next(k + 1);
    if (k + 1 < n) find_pivot(block, k + 1, choices[(k + 1) % 2]);
    each<N>(k + 2, columns, next);
  });
}
template <int N, int M>
ANIMADO_INLINE void sweep_complete(Block<N, M>& block, const Source& source) {
  const int n = block.n(), columns = block.columns();
  Choice<N> choice;
  Lane row_size[Block<N, M>::kRows], size[Block<N, M>::kRows];
  const auto measure = [&](int k, int j) {
    const Lane* a = block.column(j);
    each<N>(k, n,
            [&](int i) { row_size[i] = j == k ? absolute(a[i]) : larger(absolute(a[i]), row_size[i]); });
  };
  each<N>(0, columns, [&](int j) {
    load_column(block, source, j);
    if (j < n) measure(0, j);
  });
  each<N>(0, n, [&](int k) {
    const Lane largest = largest_of<N>(row_size, k, n), reciprocal = 1.0 / largest;
    choose<N>(row_size, k, n, largest, choice);
    each<N>(0, columns, [&](int j) { change_rows<N>(choice, k, n, block.column(j)); });
    change_rows<N>(choice, k, n, block.row_order);
    each<N>(k, n, [&](int j) { size[j] = absolute(block.column(j)[k]); });
    choose<N>(size, k, n, largest, choice);
    each<N>(0, n, [&](int i) {
      change_places<N>(choice, k, n, [&](int j) -> Lane& { return block.column(j)[i]; });
    });
    change_rows<N>(choice, k, n, block.column_order);
    divide(block, k, largest, reciprocal);
    each<N>(k + 1, columns, [&](int j) {
      subtract(block, k, block.column(j));
      if (j < n) measure(k + 1, j);
    });
  });
}

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
