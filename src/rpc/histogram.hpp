// How long things took, in bounded memory: eight steps an octave, so that a quantile is right within an
// eighth. To count costs a few nanoseconds.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "rpc/common.hpp"

namespace animado::rpc {

class Histogram {
 public:
  void count(std::chrono::nanoseconds time) { ++counts_[step_of(time.count())]; }
  std::vector<Statistics::Latency> rows() const;  // those that are not empty

 private:
  static constexpr int64_t kLongest_ns =
      (int64_t{1} << 40) - 1;               // 18 minutes; what takes longer counts as that
  static constexpr size_t kSteps = 8 * 39;  // of 40 bits: the first 3 are not divided

  static size_t step_of(int64_t ns) {
    const auto n = static_cast<uint64_t>(std::clamp<int64_t>(ns, 0, kLongest_ns));
    const int shift = std::max(static_cast<int>(std::bit_width(n)) - 4, 0);
    return 8 * static_cast<size_t>(shift) + (n >> shift);
  }
  static int64_t end_of(size_t step);  // ns; the first that belongs to the next

  std::array<int64_t, kSteps> counts_{};
};

// The time within which that part (0 … 1) of the requests was answered, µs; 0 when there were none.
double quantile_us(std::span<const Statistics::Latency> rows, double part);

// What was counted since `before`: both are rows of one histogram.
std::vector<Statistics::Latency> since(std::span<const Statistics::Latency> now,
                                       std::span<const Statistics::Latency> before);

}  // namespace animado::rpc
