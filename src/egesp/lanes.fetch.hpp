// Brings what comes next into the cache while the systems in the registers are solved.
#pragma once

#include <stdint.h>

#include "egesp/lanes.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// Brings the matrices that come kAhead systems later into the second cache, since the first is full of the
// systems at work, a few lines of memory at a time while this block is eliminated: all at once they would
// wait for each other. An element's kAhead systems lie side by side and come one after the other, because
// each element is a stream of its own, with pages of its own, and there are more of them than the processor
// follows by itself.
class Fetch {
 public:
  static constexpr size_t kAhead = 64;  // of 32×32, half a megabyte

  // As many lines for each column that changes its rows, for each in which one step or two are eliminated,
  // and for each of the last steps that is loaded or stored, make up all matrices by the end of a block.
  static constexpr int kChanging = kWidth / 8, kEliminating = 1, kEliminatingTwo = kWidth == 2 ? 1 : 2,
                       kLoading = kWidth / 2, kStoring = kWidth / 8;

  // What follows are `elements` streams, of which kAhead numbers from `next` on are fetched.
  void start(const double* next, size_t elements, size_t stride) {
    next_ = reinterpret_cast<uintptr_t>(next);
    stride_ = stride * sizeof(double);
    end_ = next_ + elements * stride_;
    left_ = kLines;
  }
  template <int kCount>
  ANIMADO_INLINE void lines() {
    if constexpr (kCount == 0) return;
#pragma GCC unroll 4
    for (size_t l = 0; l < kCount; ++l)
      __builtin_prefetch(reinterpret_cast<const void*>(next_ + l * kLine), kRead, kSecondCache);
    next_ += kCount * kLine;
    left_ -= kCount;
    if (left_ > 0) return;
    next_ += stride_ - kRun;
    left_ += kLines;
    if (next_ >= end_) next_ = end_ - kRun;
  }

 private:
  static constexpr size_t kLine = kLaneGroup * sizeof(double), kRun = kAhead * sizeof(double);
  static constexpr int kLines = kRun / kLine, kRead = 0, kSecondCache = 2;
  // Addresses, which may lie behind the last system: to fetch there does nothing.
  uintptr_t next_ = 0, end_ = 0, stride_ = 0;
  int left_ = kLines;  // of the stream's lines
};

// Right-hand sides of two groups later, and where the solutions of the next group go: what is stored waits
// for its line of memory, and whatever is stored after it waits too. They are few: all at once.
ANIMADO_INLINE void fetch_sides(const LaneBatch& batch, size_t first) {
  if (first % kLaneGroup != 0) return;
  for (int e = 0; e < batch.n * batch.m; ++e) {
    const size_t element = static_cast<size_t>(e) * batch.stride + first;
    __builtin_prefetch(batch.right_sides + element + 2 * kLaneGroup);
    __builtin_prefetch(batch.solutions + element + kLaneGroup, 1);
  }
}

}  // namespace
}  // namespace animado::egesp
