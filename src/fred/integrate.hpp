// y' = f(t, y) from t0 to t1 with steps of one length by a Runge–Kutta method.
#pragma once

#include <functional>

#include "fred/tableau.hpp"

namespace animado::fred {

// Puts f(t, y) into `rate`.
using Derivative = std::function<void(double t, std::span<const double> y, std::span<double> rate)>;

struct Interval {
  double t0 = 0, t1 = 1;  // t1 may lie before t0
  int64_t steps = 1000;   // at least 1
  int64_t samples = 0;    // at most steps; 0: the end alone

  // The fewest equal steps that are no longer than `largest_step` (0: a thousandth of the interval) and no
  // fewer than the samples.
  static Interval divided(double t0, double t1, double largest_step, int64_t samples);

  double time(int64_t step) const;  // t1 exactly at the end
};

struct Solution {
  std::vector<double>
      rows;  // (1 + max(samples, 1), 1 + size of y): t and y, the first row the start, the last the end
  int64_t evaluations = 0;
  int64_t steps = 0;  // taken before y left the finite numbers, or all
  bool finite = true;
};

Solution integrate(const Derivative& derivative, std::span<const double> start, const Interval& interval,
                   const Tableau& method);

}  // namespace animado::fred
