#include "fred/control.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "fred/powers.hpp"

namespace animado::fred {
namespace {

constexpr double kSafety = 0.9;  // the error aimed at, so that most tries are accepted
constexpr double kMostShrinking = 0.2;
constexpr double kMostGrowth = 8;  // an error that happens to vanish says nothing about the next step
// Share of the memory in the exponent. Larger damps the sizes of steps at the edge of stability, and takes
// more of them elsewhere; Hairer's codes use 0.04 · 5.
constexpr double kMemory = 0.2;

constexpr double kTinyError = 1e-10, kHugeError = 1e30;  // what lies beyond is not told apart

double norm(std::span<const double> v, std::span<const double> y, const Tolerance& tolerance) {
  double sum = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    const double scaled = v[i] / tolerance.scale(i, std::abs(y[i]));
    sum += scaled * scaled;
  }
  return std::sqrt(sum / static_cast<double>(v.size()));
}

}  // namespace

Tolerance::Tolerance(std::vector<double> absolute_of, std::vector<double> relative_of, size_t size)
    : absolute(std::move(absolute_of)), relative(std::move(relative_of)) {
  if (absolute.size() == 1 && relative.size() == 1) return;
  for (auto* values : {&absolute, &relative}) {
    assert(values->size() == 1 || values->size() == size);
    values->resize(size, values->size() == 1 ? values->front() : 1.0);
  }
}

StepControl::StepControl(int error_order) : order_(error_order + 1) {}

// The two rules are compared as logarithms, so that nothing but the acceptance is a branch that depends on
// the error: in a small system a branch that was guessed wrongly costs as much as an evaluation.
bool StepControl::accept(double error, double tried) {
  const double now = log2_near(std::clamp(error, kTinyError, kHugeError));
  if (!(error <= 1)) {
    const double factor = std::isfinite(error) ? kSafety * exp2_near(-now / order_) : 0;
    memory_.step = tried * std::max(kMostShrinking, factor);
    memory_.refused = true;
    return false;
  }
  const double last = log2_near(memory_.error), beta = kMemory / order_;
  const double proportional = beta * last - (1 / order_ - 0.75 * beta) * now;
  const double trend = memory_.taken == 0 ? std::numeric_limits<double>::infinity()
                                          : log2_near(tried / memory_.taken) + last / order_;
  const double growth = std::min(proportional, trend - 2 / order_ * now);
  const double most = memory_.refused ? 1 : kMostGrowth;  // what was refused just now would be refused again
  const double factor = kSafety * exp2_near(growth);
  memory_ = {tried * std::clamp(factor, kMostShrinking, most), std::max(error, kLeastError), tried, false};
  return true;
}

double first_step(const Derivative& derivative, double t, std::span<const double> y,
                  std::span<const double> rate, double towards, int order, const Tolerance& tolerance) {
  const double size = norm(y, y, tolerance), slope = norm(rate, y, tolerance);
  const double most = std::abs(towards);
  const double trial = std::min(most, size < 1e-5 || slope < 1e-5 ? 1e-6 : 0.01 * size / slope);
  const double h = std::copysign(trial, towards);

  std::vector<double> moved(y.size()), change(y.size());
  for (size_t i = 0; i < y.size(); ++i) moved[i] = y[i] + h * rate[i];
  derivative(t + h, moved, change);
  for (size_t i = 0; i < y.size(); ++i) change[i] -= rate[i];
  const double curvature = norm(change, y, tolerance) / trial;

  const double largest = std::max(slope, curvature);
  const double by_order =
      largest <= 1e-15 ? std::max(1e-6, trial * 1e-3) : exp2_near(log2_near(0.01 / largest) / order);
  const double chosen = std::min({100 * trial, by_order, most});
  return std::copysign(std::isfinite(chosen) && chosen > 0 ? chosen : trial, towards);
}

}  // namespace animado::fred
