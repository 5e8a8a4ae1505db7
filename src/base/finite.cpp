#include "base/finite.hpp"

#include <cmath>
#include <cstdint>

namespace animado {
namespace {

// Registers of the least processor, several in flight: a state of 10,000 bodies is passed over in each step,
// by everybody who is handed it. The compiler makes one comparison after the other of the plain loop.
using Numbers [[gnu::vector_size(16)]] = double;
using Bits [[gnu::vector_size(16)]] = int64_t;
constexpr size_t kWidth = sizeof(Numbers) / sizeof(double), kAtOnce = 4 * kWidth;

Bits beyond(const double* numbers, double most) {
  constexpr Bits kNoSign = {INT64_MAX, INT64_MAX};
  const Numbers v = {numbers[0], numbers[1]};
  const auto magnitudes = reinterpret_cast<Numbers>(reinterpret_cast<Bits>(v) & kNoSign);
  return ~(magnitudes <= Numbers{most, most});
}

}  // namespace

bool all_within(std::span<const double> numbers, double most) {
  const size_t whole = numbers.size() / kAtOnce * kAtOnce;
  Bits found[4] = {};
  for (size_t i = 0; i < whole; i += kAtOnce) {
#pragma GCC unroll 4
    for (size_t k = 0; k < 4; ++k) found[k] |= beyond(&numbers[i + k * kWidth], most);
  }
  const Bits any = (found[0] | found[1]) | (found[2] | found[3]);
  bool within = (any[0] | any[1]) == 0;
  for (double v : numbers.subspan(whole)) within = within && std::abs(v) <= most;
  return within;
}

}  // namespace animado
