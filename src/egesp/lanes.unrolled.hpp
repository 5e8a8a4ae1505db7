// The downward sweep of Gauss–Jordan elimination for the systems in one register, of a size that is known
// when compiling and small: all loops are unrolled, and a column fits the registers. The equations and the
// bits are those of echelon.hpp.
//
// Lanes with different pivots go the same way through the code: rows and columns change places under masks. A
// column is the unit of work: its rows lie side by side, so that a step takes each of them from memory once,
// brings the pivot up, and eliminates. The next column goes first: while the others follow, its pivot is
// looked for and divided by. The reciprocal is taken of the largest |a_ik|, which is known before its sign.
#pragma once

#include "egesp/lanes.block.hpp"

namespace animado::egesp {
namespace {

// Which rows (or columns) change places with the k-th, each in the lanes of its mask.
template <int N>
using Masks = Mask[N];

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

// max size_i, i ≥ k, by halves: the order changes no bit of a maximum and shortens the wait for it.
template <int N>
ANIMADO_INLINE Lane largest_of(const Lane* size, int k) {
  Lane tree[N];
  each<N>(k, N, [&](int i) { tree[i] = size[i]; });
#pragma GCC unroll 8
  for (int step = 1; step < N - k; step *= 2) {
#pragma GCC unroll 8
    for (int i = k; i + step < N; i += 2 * step) tree[i] = larger(tree[i], tree[i + step]);
  }
  return tree[k];
}

// The first whose size is the largest goes to k. One of them is, so the last is chosen where no other was.
template <int N>
ANIMADO_INLINE void choose(const Lane* size, int k, Lane largest, Masks<N>& choice) {
  Mask taken = equal(size[k], largest);
  each<N>(k + 1, N, [&](int i) {
    const Mask candidate = i == N - 1 ? ~Mask{} : equal(size[i], largest);
    choice[i] = candidate & ~taken;
    taken |= candidate;
  });
}

// place(i): the i-th of what changes places.
template <int N, class Place>
ANIMADO_INLINE void change_places(const Masks<N>& choice, int k, const Place& place) {
  const Lane old = place(k);
  Lane top = old;
  each<N>(k + 1, N, [&](int i) { place(i) = exchanged(choice[i], place(i), old, top); });
  place(k) = top;
}

template <int N>
ANIMADO_INLINE void change_rows(const Masks<N>& choice, int k, Lane* column) {
  change_places<N>(choice, k, [&](int i) -> Lane& { return column[i]; });
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
ANIMADO_INLINE void find_pivot(Block<N, M>& block, int k, Masks<N>& choice) {
  const int n = block.n();
  Lane* a = block.column(k);
  Lane size[Block<N, M>::kRows];
  each<N>(k, n, [&](int i) { size[i] = absolute(a[i]); });
  const Lane largest = largest_of<N>(size, k), reciprocal = 1.0 / largest;
  choose<N>(size, k, largest, choice);
  change_rows<N>(choice, k, a);
  divide(block, k, largest, reciprocal);
}

template <int N, int M>
ANIMADO_INLINE void subtract(Block<N, M>& block, int k, Lane* column) {
  const Lane* factor = block.column(k);
  const Lane top = column[k];
  each<N>(k + 1, block.n(), [&](int i) { column[i] -= factor[i] * top; });
}

// load(j): brings column j, before the first step.
template <int N, int M, class Load>
ANIMADO_INLINE void sweep_partial(Block<N, M>& block, const Load& load) {
  const int n = block.n(), columns = block.columns();
  Masks<N> choices[2];  // of this step and of the next
  load(0);
  find_pivot(block, 0, choices[0]);
  each<N>(0, n, [&](int k) {
    const Masks<N>& choice = choices[k % 2];
    const auto next = [&](int j) {
      Lane* column = block.column(j);
      if (k == 0) load(j);
      change_rows<N>(choice, k, column);
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
  Masks<N> choice;
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
    const Lane largest = largest_of<N>(row_size, k), reciprocal = 1.0 / largest;
    choose<N>(row_size, k, largest, choice);
    each<N>(0, columns, [&](int j) { change_rows<N>(choice, k, block.column(j)); });
    change_rows<N>(choice, k, block.row_order);
    each<N>(k, n, [&](int j) { size[j] = absolute(block.column(j)[k]); });
    choose<N>(size, k, largest, choice);
    each<N>(0, n,
            [&](int i) { change_places<N>(choice, k, [&](int j) -> Lane& { return block.column(j)[i]; }); });
    change_rows<N>(choice, k, block.column_order);
    divide(block, k, largest, reciprocal);
    each<N>(k + 1, columns, [&](int j) {
      subtract(block, k, block.column(j));
      if (j < n) measure(k + 1, j);
    });
  });
}

}  // namespace
}  // namespace animado::egesp
