#include "controle/step_size.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/state.hpp"

namespace animado::controle {
namespace {

// Error a second that a step may make, relative to 1 + |y|, when the scene gives no `tolerance`. Over the 100
// s of a long scene it adds up to 1e-9, what a table printed with nine decimals can show; rounding alone
// makes about 1e-13 a second at a thousand steps a second.
constexpr double kToleranceRate = 1e-11;

constexpr double kShortest_s = 1e-6;  // shorter ones would only gather rounding
constexpr double kSafety = 0.9;
constexpr int kMostTrials = 6;

}  // namespace

StepSize::StepSize(FreeMotion& motion, size_t bodies, std::optional<double> given_s,
                   std::optional<double> tolerance)
    : motion_(motion),
      bodies_(bodies),
      order_(motion.order()),
      tolerance_rate_(tolerance.value_or(kToleranceRate)),
      given_s_(given_s),
      last_s_(kLongestStep_s),
      whole_(motion.make_state("trial_whole")),
      half_(motion.make_state("trial_half")),
      halves_(motion.make_state("trial_halves")) {}

// Infinite where the motion diverges, which it may not do in a shorter step.
double StepSize::error_rate(const Lanes& state, double time_s, double step_s) try {
  motion_.step(state, time_s, step_s, whole_);
  motion_.step(state, time_s, step_s / 2, half_);
  motion_.step(half_, time_s + step_s / 2, step_s / 2, halves_);
  double worst = 0;
  for (size_t k = 0; k < kStateRows * bodies_; ++k) {
    const double difference = std::abs(whole_.values[k] - halves_.values[k]);
    if (!std::isfinite(difference)) return INFINITY;
    worst = std::max(worst, difference / (1 + std::abs(halves_.values[k])));
  }
  // Richardson: the whole step's error is the difference times 2^p / (2^p − 1).
  const double power = std::pow(2.0, order_);
  return worst * power / (power - 1) / step_s;
} catch (const Error& error) {
  if (error.code() != Code::diverged) throw;
  return INFINITY;
}

size_t StepSize::steps(const Lanes& state, double time_s, double interval_s, double most_s) {
  const auto cut = [&](double step_s) {
    // A hair of slack, so that rounding in interval/step adds no step.
    return static_cast<size_t>(std::max(1.0, std::ceil(interval_s / step_s * (1 - 1e-12))));
  };
  if (given_s_) return cut(std::min(*given_s_, most_s));

  double step_s = std::min({2 * last_s_, kLongestStep_s, interval_s, most_s});
  for (int trial = 0; trial < kMostTrials; ++trial) {
    const double rate = error_rate(state, time_s, step_s);
    if (rate <= tolerance_rate_) break;
    const double factor =
        std::isfinite(rate) ? kSafety * std::pow(tolerance_rate_ / rate, 1.0 / order_) : kAfterDivergence;
    step_s = std::max(kShortest_s, step_s * std::min(factor, 0.9));
  }
  last_s_ = step_s;
  return cut(step_s);
}

}  // namespace animado::controle
