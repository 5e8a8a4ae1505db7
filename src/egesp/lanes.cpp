// The kernels of one instruction set. This file is compiled once for each, with the name of its entry and the
// width of a register given by the build.
#include "egesp/lanes.hpp"
#include "egesp/lanes.fetch.hpp"
#include "egesp/lanes.looped.hpp"
#include "egesp/lanes.substitution.hpp"
#include "egesp/lanes.unrolled.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// Of one right-hand side: larger ones do not fit the registers, and their code not its cache.
constexpr int kLargestUnrolled = 6;

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

// With the downward sweep done for the systems from `first` on.
template <bool kComplete, int N, int M>
ANIMADO_INLINE void finish(Block<N, M>& block, const LaneBatch& batch, size_t first) {
  const Lane sum = sweep_upward(block);
  store_solutions<kComplete>(block, batch, first);
  store(batch.solved + first, block.accepted(batch.tolerance) & (absolute(sum) <= kLargest));
}

Source source(const LaneBatch& batch, size_t first) {
  return {batch.matrices + first, batch.right_sides + first, batch.stride};
}

template <bool kComplete, int N, int M>
void solve_unrolled(const LaneBatch& batch) {
  Block<N, M> block(N, M);
  for (size_t first = 0; first < batch.count; first += kWidth) {
    const Source from = source(batch, first);
    if constexpr (kComplete) {
      number_order(block);
      sweep_complete(block, from);
    } else {
      sweep_partial(block, [&](int j) { load_column(block, from, j); });
    }
    finish<kComplete>(block, batch, first);
  }
}

template <bool kComplete>
void solve_looped(const LaneBatch& batch) {
  Block<0, 0> block(batch.n, batch.m);
  LoopedSweep<false> sweep(block);
  for (size_t first = 0; first < batch.count; first += kWidth) {
    if (first % Fetch::kAhead == 0) sweep.fetch(batch.matrices + first + Fetch::kAhead, batch.stride);
    const Lane largest = sweep.load(source(batch, first));
    fetch_sides(batch, first);
    if constexpr (kComplete) {
      number_order(block);
      sweep.complete();
    } else {
      sweep.partial(largest);
    }
    finish<kComplete>(block, batch, first);
  }
}

template <bool kComplete>
void solve_size(const LaneBatch& batch) {
  if (batch.m > 1 || batch.n > kLargestUnrolled) return solve_looped<kComplete>(batch);
  unrolled<kLargestUnrolled - 1>(batch.n - 1,
                                 [&]<int kBefore>() { solve_unrolled<kComplete, kBefore + 1, 1>(batch); });
}

void solve(const LaneBatch& batch) {
  batch.complete ? solve_size<true>(batch) : solve_size<false>(batch);
}

void factor(const LaneFactoring& group) {
  const int n = group.n;
  Block<0, 0> block(n, 0);
  LoopedSweep<true> sweep(block);
  for (size_t first = 0; first < kLaneGroup; first += kWidth) {
    const Lane largest = sweep.load({group.matrices + first, nullptr, group.stride});
    number_order(block);
    group.complete ? sweep.complete() : sweep.partial(largest);
    const auto put = [&](double* numbers, int e, Lane v) {
      store(numbers + static_cast<size_t>(e) * kLaneGroup + first, v);
    };
    for (int k = 0; k < n; ++k) {
      block.column(k)[k] = block.inverse[k];
      put(group.order, k, block.row_order[k]);
      put(group.order, n + k, block.column_order[k]);
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) put(group.factors, j * n + i, block.column(j)[i]);
    }
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
