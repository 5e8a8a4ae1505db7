// The kernels of one instruction set. This file is compiled once for each, with the name of its entry and the
// width of a register given by the build.
#include "egesp/lanes.hpp"
#include "egesp/lanes.elimination.hpp"
#include "egesp/lanes.substitution.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

template <int N, int M>
ANIMADO_INLINE void number_order(Block<N, M>& block) {
  for (int k = 0; k < block.n(); ++k) block.row_order[k] = block.column_order[k] = Lane{} + k;
}

template <bool kComplete, int N, int M>
ANIMADO_INLINE void store_solutions(Block<N, M>& block, const LaneBatch& batch, size_t first) {
  const int n = block.n(), m = block.m();
  const auto to = [&](size_t row, int j) {
    return batch.solutions + (row * static_cast<size_t>(m) + static_cast<size_t>(j)) * batch.stride + first;
  };
  each<N>(0, m, [&](int j) {
    const Lane* x = block.column(n + j);
    if constexpr (kComplete) {
      for (int k = 0; k < n; ++k) {
        for (size_t lane = 0; lane < kWidth; ++lane)
          to(static_cast<size_t>(block.column_order[k][lane]), j)[lane] = x[k][lane];
      }
    } else {
      each<N>(0, n, [&](int i) { store(to(static_cast<size_t>(i), j), x[i]); });
    }
  });
}

template <bool kComplete, int N, int M>
void solve_blocks(const LaneBatch& batch) {
  Block<N, M> block(batch.n, batch.m);
  for (size_t first = 0; first < batch.count; first += kWidth) {
    const Source source{batch.matrices + first, batch.right_sides + first, batch.stride};
    if constexpr (kComplete) {
      number_order(block);
      sweep_complete(block, source);
    } else {
      sweep_partial<false>(block, source);
    }
    const Lane sum = sweep_upward(block);
    store_solutions<kComplete>(block, batch, first);
    store(batch.solved + first, block.accepted(batch.tolerance) & (absolute(sum) <= kLargest));
  }
}

template <bool kComplete>
void solve_size(const LaneBatch& batch) {
  if (batch.n == 6 && batch.m == 1) {
    solve_blocks<kComplete, 6, 1>(batch);
  } else {
    solve_blocks<kComplete, 0, 0>(batch);
  }
}

void solve(const LaneBatch& batch) {
  batch.complete ? solve_size<true>(batch) : solve_size<false>(batch);
}

void factor(const LaneFactoring& group) {
  const int n = group.n;
  Block<0, 0> block(n, 0);
  for (size_t first = 0; first < kLaneGroup; first += kWidth) {
    const Source source{group.matrices + first, nullptr, group.stride};
    number_order(block);
    group.complete ? sweep_complete(block, source) : sweep_partial<true>(block, source);
    const auto put = [&](double* numbers, int e, Lane v) {
      store(numbers + static_cast<size_t>(e) * kLaneGroup + first, v);
    };
    for (int k = 0; k < n; ++k) {
      block.column(k)[k] = block.inverse[k];
      put(group.order, k, block.row_order[k]);
      put(group.order, n + k, block.column_order[k]);
    }
    for (int e = 0; e < n * n; ++e) put(group.factors, e, block.a[e]);
    store(group.solved + first, block.accepted(group.tolerance));
  }
}

bool substitute(const LaneSubstitution& batch) {
  return batch.n == 6 ? substitute_groups<6>(batch) : substitute_groups<0>(batch);
}

}  // namespace

LaneKernels ANIMADO_LANE_ENTRY() {
  return {solve, factor, substitute};
}

}  // namespace animado::egesp
