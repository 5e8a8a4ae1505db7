// Brings what comes next into the cache while the systems in the registers are solved.
#pragma once

#include <stdint.h>

#include "egesp/lanes.hpp"
#include "egesp/lanes.vector.hpp"

namespace animado::egesp {
namespace {

// Brings the matrices that come kAhead systems later into the cache, a few lines of memory at a time while
// this block is eliminated: all at once they would wait for each other. An element's kAhead systems lie side
// by side and come one after the other, because each element is a stream of its own, with pages of its own,
// and there are more of them than the processor follows by itself.
class Fetch {
 public:
  static constexpr size_t kAhead = 64;

  // What follows are `elements` streams, of which kAhead numbers from `next` on are fetched.
  void start(const double* next, size_t elements, size_t stride) {
    next_ = reinterpret_cast<uintptr_t>(next);
    stride_ = stride * sizeof(double);
    end_ = next_ + elements * stride_;
    fetched_ = 0;
  }
  // kCount: a divisor of a run's lines.
  template <int kCount>
  ANIMADO_INLINE void lines() {
#pragma GCC unroll 8
    for (size_t l = 0; l < kCount; ++l) __builtin_prefetch(reinterpret_cast<const void*>(next_ + l * kLine));
    next_ += kCount * kLine;
    fetched_ += kCount;
    if (fetched_ % (kRun / kLine) != 0) return;
    next_ += stride_ - kRun;
    if (next_ >= end_) next_ = end_ - kRun;
  }

 private:
  static constexpr size_t kLine = kLaneGroup * sizeof(double), kRun = kAhead * sizeof(double);
  // Addresses, which may lie behind the last system: to fetch there does nothing.
  uintptr_t next_ = 0, end_ = 0, stride_ = 0;
  unsigned fetched_ = 0;
};

}  // namespace
}  // namespace animado::egesp
