// Gauss–Jordan elimination with partial pivoting of several small systems at once, one a lane of a vector
// register: the equations and the bits are those of gauss_jordan.hpp.
//
// Lanes with different pivots go the same way through the code: rows are exchanged under masks, two bitwise
// operations an element. The reciprocal is taken of the largest |a_ik|, which is known before the rows have
// moved.
//
// This file is compiled three times, with the name of its entry and the width of a register given by the
// build. Everything else has internal linkage and no standard header is included: an inline function compiled
// here for AVX-512 must not become the copy that the linker keeps for the whole program.
#include "egesp/lanes.hpp"

namespace animado::egesp {
namespace {

using Lane = double __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using Mask = long long __attribute__((vector_size(ANIMADO_LANE_BYTES)));
using UnalignedLane = double __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));
using UnalignedMask = long long __attribute__((vector_size(ANIMADO_LANE_BYTES), aligned(8), may_alias));

constexpr size_t kWidth = ANIMADO_LANE_BYTES / sizeof(double);
constexpr double kSmallestPivot = 0x1p-1022;  // the reciprocal of less overflows
constexpr double kLargest = 0x1.fffffffffffffp1023;
constexpr long long kMagnitude = 0x7fffffffffffffff;

#define ANIMADO_INLINE [[gnu::always_inline]] inline
#define ANIMADO_UNROLL _Pragma("GCC unroll 16")

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

// The exchange of row k with the row that each lane chose: `here` marks the lanes that chose row i.
//   first, take: the new row k, gathered over all i ≥ k;   difference, give: what row i becomes.
#if ANIMADO_LANE_BYTES == 64
// Masks have registers of their own, and a blend is one instruction.
ANIMADO_INLINE Lane larger(Lane u, Lane v) {
  return __builtin_ia32_maxpd512_mask(u, v, v, 0xff, 4);
}
ANIMADO_INLINE Mask equal(Lane u, Lane v) {
  return u == v;
}
ANIMADO_INLINE Lane first(Mask, Lane old) {
  return old;
}
ANIMADO_INLINE Lane take(Lane row, Mask here, Lane v) {
  return here ? v : row;
}
ANIMADO_INLINE Lane difference(Lane, Lane old) {
  return old;
}
ANIMADO_INLINE Lane give(Lane v, Mask here, Lane difference) {
  return here ? difference : v;
}
#else
ANIMADO_INLINE Lane larger(Lane u, Lane v) {
  return u > v ? u : v;
}
ANIMADO_INLINE Mask equal(Lane u, Lane v) {
  Mask mask = u == v;
  asm(""
      : "+x"(mask));  // a mask that the compiler sees through becomes branches (SSE2) or blends of three
                      // steps (AVX2)
  return mask;
}
ANIMADO_INLINE Lane first(Mask here, Lane old) {
  return (Lane)((Mask)old & here);
}
ANIMADO_INLINE Lane take(Lane row, Mask here, Lane v) {
  return (Lane)((Mask)row | ((Mask)v & here));
}
ANIMADO_INLINE Lane difference(Lane row, Lane old) {
  return (Lane)((Mask)row ^ (Mask)old);
}
ANIMADO_INLINE Lane give(Lane v, Mask here, Lane difference) {
  return (Lane)((Mask)v ^ ((Mask)difference & here));
}
#endif

// Systems side by side, A beside B. N, M: the size where it is known when compiling, else 0.
template <int N, int M>
struct Block {
  static constexpr int kRows = N ? N : kLaneSize;
  static constexpr int kColumns = N ? N + M : 2 * kLaneSize + 1;  // rows 4 KiB apart would share cache sets
  int n = N, columns = N + M;
  Lane a[kRows][kColumns];
  Lane inverse[kRows];  // of the pivots
  Mask solved;
};

template <int N, int M>
ANIMADO_INLINE Lane load_block(Block<N, M>& block, const LaneBatch& batch, size_t first_system) {
  const int n = block.n, columns = block.columns, m = columns - n;
  Lane largest = {};
  ANIMADO_UNROLL for (int i = 0; i < n; ++i) {
    ANIMADO_UNROLL for (int j = 0; j < n; ++j) {
      block.a[i][j] = load(batch.matrices + (i * n + j) * batch.stride + first_system);
      largest = larger(absolute(block.a[i][j]), largest);
    }
    ANIMADO_UNROLL for (int j = 0; j < m; ++j) block.a[i][n + j] =
        load(batch.right_sides + (i * m + j) * batch.stride + first_system);
  }
  return largest;
}

// max |a_ik|, i ≥ k, by halves: the order changes no bit of a maximum and shortens the wait for it.
template <int N, int M>
ANIMADO_INLINE Lane largest_below(const Block<N, M>& block, int k) {
  const int n = block.n;
  Lane size[Block<N, M>::kRows];
  size[k] = absolute(block.a[k][k]);
  ANIMADO_UNROLL for (int i = k + 1; i < n; ++i) size[i] = absolute(block.a[i][k]);
  ANIMADO_UNROLL for (int step = 1; step < n - k; step *= 2)
      ANIMADO_UNROLL for (int i = k; i + step < n; i += 2 * step) size[i] = larger(size[i], size[i + step]);
  return size[k];
}

// Exchanges row k with the first that holds the pivot, and eliminates column k below it.
template <int N, int M>
ANIMADO_INLINE void eliminate_column(Block<N, M>& block, int k, Lane best) {
  const int n = block.n, columns = block.columns;
  auto& a = block.a;
  Mask here[Block<N, M>::kRows];
  Mask open = ~Mask{};
  ANIMADO_UNROLL for (int i = k; i < n; ++i) {
    const Mask candidate = equal(absolute(a[i][k]), best);
    here[i] = candidate & open;
    open &= ~candidate;
  }
  Lane change[Block<N, M>::kColumns];
  ANIMADO_UNROLL for (int j = k; j < columns; ++j) {
    Lane pivot = first(here[k], a[k][j]);
    ANIMADO_UNROLL for (int i = k + 1; i < n; ++i) pivot = take(pivot, here[i], a[i][j]);
    change[j] = difference(pivot, a[k][j]);
    a[k][j] = pivot;
  }
  const Lane inverse = block.inverse[k] = with_sign(1.0 / best, a[k][k]);
  ANIMADO_UNROLL for (int i = k + 1; i < n; ++i) {
    const Lane factor = give(a[i][k], here[i], change[k]) * inverse;
    ANIMADO_UNROLL for (int j = k + 1; j < columns; ++j) a[i][j] =
        give(a[i][j], here[i], change[j]) - factor * a[k][j];
  }
}

template <int N, int M>
ANIMADO_INLINE void substitute_upward(Block<N, M>& block) {
  const int n = block.n, columns = block.columns;
  auto& a = block.a;
  ANIMADO_UNROLL for (int k = n - 1; k >= 0; --k) {
    ANIMADO_UNROLL for (int j = n; j < columns; ++j) {
      a[k][j] *= block.inverse[k];
      block.solved &= absolute(a[k][j]) <= kLargest;
      ANIMADO_UNROLL for (int i = 0; i < k; ++i) a[i][j] -= a[i][k] * a[k][j];
    }
  }
}

template <int N, int M>
ANIMADO_INLINE void store_block(const Block<N, M>& block, const LaneBatch& batch, size_t first_system) {
  const int n = block.n, m = block.columns - n;
  ANIMADO_UNROLL for (int i = 0; i < n; ++i) ANIMADO_UNROLL for (int j = 0; j < m; ++j)
      store(batch.solutions + (i * m + j) * batch.stride + first_system, block.a[i][n + j]);
  store(batch.solved + first_system, block.solved);
}

template <int N, int M>
void solve_blocks(const LaneBatch& batch) {
  Block<N, M> block;
  if (N == 0) block.n = batch.n, block.columns = batch.n + batch.m;
  for (size_t system = 0; system < batch.count; system += kWidth) {
    const Lane largest = load_block(block, batch, system);
    const Lane floor = larger(largest * batch.tolerance, Lane{} + kSmallestPivot);
    block.solved = ~Mask{};
    ANIMADO_UNROLL for (int k = 0; k < block.n; ++k) {
      const Lane best = largest_below(block, k);
      block.solved &= best > floor;
      eliminate_column(block, k, best);
    }
    substitute_upward(block);
    store_block(block, batch, system);
  }
}

}  // namespace

void ANIMADO_LANE_ENTRY(const LaneBatch& batch) {
  if (batch.n == 6 && batch.m == 1) {
    solve_blocks<6, 1>(batch);
  } else if (batch.n == 15 && batch.m == 1) {
    solve_blocks<15, 1>(batch);
  } else {
    solve_blocks<0, 0>(batch);
  }
}

}  // namespace animado::egesp
