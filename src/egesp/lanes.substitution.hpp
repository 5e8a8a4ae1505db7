// Right-hand sides against factors that were made before (LaneFactoring): L y = P b, U Q⁻¹ x = y. Each
// element of b meets the same terms in the same order as when it goes through the elimination beside its
// matrix, so the solutions have the same bits.
#pragma once

#include "egesp/lanes.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// `numbers` points at the first system's; element e lies at e · step. order: which element each lane takes
// for k, null when it is the k-th.
template <int N>
ANIMADO_INLINE void take(Lane* b, int n, const double* numbers, size_t step, const unsigned char* order) {
  if (!order) {
    each<N>(0, n, [&](int k) { b[k] = load(numbers + static_cast<size_t>(k) * step); });
  } else {
    for (int k = 0; k < n; ++k, order += kLaneGroup) {
      for (size_t lane = 0; lane < kWidth; ++lane) b[k][lane] = numbers[order[lane] * step + lane];
    }
  }
}

template <int N>
ANIMADO_INLINE void put(const Lane* x, int n, double* numbers, size_t step, const unsigned char* order) {
  if (!order) {
    each<N>(0, n, [&](int k) { store(numbers + static_cast<size_t>(k) * step, x[k]); });
  } else {
    for (int k = 0; k < n; ++k, order += kLaneGroup) {
      for (size_t lane = 0; lane < kWidth; ++lane) numbers[order[lane] * step + lane] = x[k][lane];
    }
  }
}

template <int N>
bool substitute_groups(const LaneSubstitution& batch) {
  const int n = N ? N : batch.n;
  const auto m = static_cast<size_t>(batch.m);
  Lane sum = {};
  for (size_t first = 0; first < batch.count; first += kWidth) {
    const LaneFactors& group = batch.groups[first / kLaneGroup];
    const size_t inside = first % kLaneGroup;
    const auto factor = [&](int i, int k) {
      return load(group.factors + static_cast<size_t>(k * n + i) * kLaneGroup + inside);
    };
    for (size_t side = 0; side < m; ++side) {
      const size_t offset = side * batch.stride + first, step = m * batch.stride;
      Lane b[N ? N : kLaneSize], own = {};
      take<N>(b, n, batch.right_sides + offset, step, group.rows ? group.rows + inside : nullptr);
      each<N>(0, n, [&](int k) { each<N>(k + 1, n, [&](int i) { b[i] -= factor(i, k) * b[k]; }); });
      each<N>(0, n, [&](int from_last) {
        const int k = n - 1 - from_last;
        b[k] *= factor(k, k);
        own += b[k];
        each<N>(0, k, [&](int i) { b[i] -= factor(i, k) * b[k]; });
      });
      put<N>(b, n, batch.solutions + offset, step, group.columns ? group.columns + inside : nullptr);
      sum += own;
    }
  }
  return finite(sum);
}

}  // namespace
}  // namespace animado::egesp
