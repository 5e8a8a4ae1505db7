#include "animado/axis_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace animado {

namespace {

double round_step(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  // The nearest by ratio: the bounds are the geometric means of neighbours.
  const double digits = wanted / power;
  return power * (digits < std::sqrt(2) ? 1 : digits < std::sqrt(10) ? 2 : digits < std::sqrt(50) ? 5 : 10);
}

// 0.002 … 9999 are read well as they are.
int exponent_of(double largest) {
  if (largest >= 1e-3 && largest < 1e4) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

}  // namespace

Ticks ticks_of(double low, double high, int count) {
  // Rounding alone is no change: a constant of 1e3 that differs in its last digits is a constant.
  const double largest = std::max(std::abs(low), std::abs(high));
  if (high - low <= 1e-12 * largest || largest == 0) {
    const double margin = largest == 0 ? 1 : 0.1 * largest;
    low -= margin, high += margin;
  }
  const double step = round_step((high - low) / count);
  Ticks ticks{low, high, {}, {}, exponent_of(std::max(std::abs(low), std::abs(high)))};
  const double unit = std::pow(10, ticks.exponent);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)));
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    ticks.at.push_back(k * step);
    ticks.labels.push_back(fmt::format("{:.{}f}", k == 0 ? 0.0 : k * step / unit, decimals));
  }
  return ticks;
}

}  // namespace animado
