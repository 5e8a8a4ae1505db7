#include "fred/control.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fred/lanes.hpp"

namespace animado::fred {
namespace {

constexpr double kSafety = 0.9;  // the error aimed at, so that most tries are accepted
constexpr double kMostShrinking = 0.2;
constexpr double kMostGrowth = 8;  // an error that happens to vanish says nothing about the next step
// Share of the memory in the exponent. Larger damps the sizes of steps at the edge of stability, and takes
// more of them elsewhere; Hairer's codes use 0.04 · 5.
constexpr double kMemory = 0.2;

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
  const size_t padded = (size + kLaneGroup - 1) / kLaneGroup * kLaneGroup;
  for (auto* values : {&absolute, &relative}) {
    assert(values->size() == 1 || values->size() == size);
    values->resize(padded, values->size() == 1 ? values->front() : 1.0);
  }
}

StepControl::StepControl(int error_order) : order_(error_order + 1) {}

bool StepControl::accept(double error, double tried) {
  if (!(error <= 1)) {
    const double factor = std::isfinite(error) ? kSafety * std::pow(error, -1 / order_) : kMostShrinking;
    memory_.step = tried * std::max(kMostShrinking, factor);
    memory_.refused = true;
    return false;
  }
  const double beta = kMemory / order_;
  // error^(0.75 β − 1/order) times the last error^β: by logarithms, which cost half as much as two powers.
  const double factor = kSafety * std::exp((0.75 * beta - 1 / order_) * std::log(std::max(error, 1e-10)) +
                                           beta * std::log(memory_.error));
  const double most = memory_.refused ? 1 : kMostGrowth;  // what was refused just now would be refused again
  memory_.step = tried * std::clamp(factor, kMostShrinking, most);
  memory_.error = std::max(error, kLeastError);
  memory_.refused = false;
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
      largest <= 1e-15 ? std::max(1e-6, trial * 1e-3) : std::pow(0.01 / largest, 1.0 / order);
  const double chosen = std::min({100 * trial, by_order, most});
  return std::copysign(std::isfinite(chosen) && chosen > 0 ? chosen : trial, towards);
}

}  // namespace animado::fred
