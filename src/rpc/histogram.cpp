#include "rpc/histogram.hpp"

#include <algorithm>

namespace animado::rpc {

// Steps 8 s … 8 s + 7 begin with the four bits 8 … 15 of numbers shifted by s; before 8, a step is 1 ns.
int64_t Histogram::end_of(size_t step) {
  const size_t next = step + 1;
  const size_t shift = next < 16 ? 0 : next / 8 - 1;
  return static_cast<int64_t>((next - 8 * shift) << shift);
}

std::vector<Statistics::Latency> Histogram::rows() const {
  std::vector<Statistics::Latency> rows;
  for (size_t step = 0; step < kSteps; ++step) {
    if (counts_[step] > 0) rows.push_back({1e-3 * static_cast<double>(end_of(step)), counts_[step]});
  }
  return rows;
}

double quantile_us(std::span<const Statistics::Latency> rows, double part) {
  int64_t total = 0;
  for (const auto& row : rows) total += row.requests;
  double missing = part * static_cast<double>(total);
  for (const auto& row : rows) {
    missing -= static_cast<double>(row.requests);
    if (missing <= 0) return row.below_us;
  }
  return 0;
}

std::vector<Statistics::Latency> since(std::span<const Statistics::Latency> now,
                                       std::span<const Statistics::Latency> before) {
  std::vector<Statistics::Latency> rows;
  auto old = before.begin();
  for (Statistics::Latency row : now) {
    old = std::find_if(old, before.end(), [&](const auto& other) { return other.below_us >= row.below_us; });
    if (old != before.end() && old->below_us == row.below_us) row.requests -= old->requests;
    if (row.requests > 0) rows.push_back(row);
  }
  return rows;
}

}  // namespace animado::rpc
