#include "fred/integrate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fred/stage.hpp"

namespace animado::fred {
namespace {

// A step from (t, y); `end` is where it arrives.
class Stepper {
 public:
  Stepper(const Derivative& derivative, const Tableau& method, size_t size)
      : derivative_(derivative), method_(method), size_(size), rates_(method.stages() * size), stage_(size) {}

  void step(double t, double step, std::span<const double> y, std::span<double> end) {
    for (size_t s = 0; s < method_.stages(); ++s) {
      if (s > 0) combine(y, rates_, method_.coefficients(s), step, stage_);
      derivative_(t + method_.nodes[s] * step, s == 0 ? y : stage_,
                  std::span(rates_).subspan(s * size_, size_));
    }
    combine(y, rates_, method_.weights, step, end);
  }

 private:
  const Derivative& derivative_;
  const Tableau& method_;
  size_t size_;
  std::vector<double> rates_, stage_;
};

void append_row(Solution& solution, double t, std::span<const double> y) {
  solution.rows.push_back(t);
  solution.rows.insert(solution.rows.end(), y.begin(), y.end());
}

}  // namespace

Interval Interval::divided(double t0, double t1, double largest_step, int64_t samples) {
  // A quotient that rounding lifted just above a whole number is that number: 1.1 / 0.1 asks for 11 steps.
  const double wanted = largest_step > 0 ? std::ceil(std::abs(t1 - t0) / largest_step * (1 - 0x1p-50)) : 1000;
  return {t0, t1, std::max({int64_t{1}, samples, static_cast<int64_t>(std::min(wanted, 0x1p62))}), samples};
}

double Interval::time(int64_t step) const {
  return step == steps ? t1 : t0 + static_cast<double>(step) * ((t1 - t0) / static_cast<double>(steps));
}

Solution integrate(const Derivative& derivative, std::span<const double> start, const Interval& interval,
                   const Tableau& method) {
  assert(interval.steps >= 1 && interval.samples <= interval.steps);
  const double step = (interval.t1 - interval.t0) / static_cast<double>(interval.steps);
  const int64_t samples = std::max(interval.samples, int64_t{1});
  Stepper stepper(derivative, method, start.size());
  std::vector<double> y(start.begin(), start.end()), end(start.size());
  Solution solution;
  append_row(solution, interval.t0, start);
  int64_t sample = 1;
  while (solution.steps < interval.steps) {
    stepper.step(interval.time(solution.steps), step, y, end);
    solution.evaluations += static_cast<int64_t>(method.stages());
    solution.finite = std::ranges::all_of(end, [](double v) { return std::isfinite(v); });
    if (!solution.finite) break;
    std::swap(y, end);
    ++solution.steps;
    if (solution.steps == sample * interval.steps / samples) {
      append_row(solution, interval.time(solution.steps), y);
      ++sample;
    }
  }
  return solution;
}

}  // namespace animado::fred
