#include "fred/adaptive_steps.hpp"

#include <algorithm>

#include "base/finite.hpp"
#include "fred/radau.hpp"
#include "fred/runge_kutta.hpp"

namespace animado::fred {

template <class Core>
AdaptiveSteps<Core>::AdaptiveSteps(Core core, AdaptiveMethod method, Derivative derivative, double t,
                                   Tolerance tolerance, double largest)
    : core_(std::move(core)),
      method_(std::move(method)),
      derivative_(derivative),
      tolerance_(std::move(tolerance)),
      control_(method_.error_order),
      largest_(largest) {
  from_ = t_ = t;
}

template <class Core>
void AdaptiveSteps<Core>::resume(const Checkpoint& from) {
  before_ = control_.memory() = from.control;
  if (!from.rate.empty()) core_.set_rate(from.rate);
}

template <class Core>
void AdaptiveSteps<Core>::choose_first(double end) {
  const auto rate = core_.rate(t_);
  control_.memory().step = first_step(derivative_, t_, core_.y(), rate, end - t_, method_.order, tolerance_);
  ++trial_evaluations_;
}

template <class Core>
Stepper::Outcome AdaptiveSteps<Core>::advance(const Reach& reach) {
  const double direction = reach.end < t_ ? -1 : 1;
  for (int64_t left = reach.most; left > 0; --left) {
    const Outcome outcome = take_step(reach.end);
    if (outcome != Outcome::stepped) return outcome;
    ++steps_;
    if (direction * (t_ - reach.until) >= 0) break;
  }
  return Outcome::stepped;
}

template <class Core>
Stepper::Outcome AdaptiveSteps<Core>::take_step(double end) {
  if (pending_) core_.accept();
  pending_ = false;
  from_ = t_;
  if (control_.memory().step == 0) choose_first(end);
  before_ = control_.memory();
  for (;;) {
    double h = control_.memory().step;
    if (largest_ > 0) h = std::clamp(h, -largest_, largest_);
    // A last step that is a hair longer beats one more that is tiny.
    whole_ = std::abs(end - t_) > 1.01 * std::abs(h);
    if (!whole_) h = end - t_;
    if (is_too_small(h, t_)) return failure();
    if (control_.accept(core_.attempt(t_, h) ? core_.error(tolerance_) : NAN, h)) {
      t_ = whole_ ? t_ + h : end;
      pending_ = true;
      return Outcome::stepped;
    }
    ++refused_;
  }
}

template <class Core>
Stepper::Outcome AdaptiveSteps<Core>::failure() {
  return all_finite(core_.rate(t_)) ? Outcome::step_too_small : Outcome::not_finite;
}

template <class Core>
void AdaptiveSteps<Core>::interpolate(double t, std::span<double> out) {
  if (t == t_ || !pending_) {
    std::ranges::copy(y(), out.begin());
  } else {
    core_.interpolate((t - from_) / (t_ - from_), out);
  }
}

template <class Core>
Checkpoint AdaptiveSteps<Core>::checkpoint(bool at_start) {
  const bool start = at_start || !pending_;
  Checkpoint point;
  point.method = method_.name;
  point.t = start ? from_ : t_;
  point.control = start ? before_ : control_.memory();
  const auto y = start ? core_.y() : core_.end();
  const auto rate = core_.known_rate(start);
  point.y.assign(y.begin(), y.end());
  point.rate.assign(rate.begin(), rate.end());
  return point;
}

template class AdaptiveSteps<RungeKutta>;
template class AdaptiveSteps<Radau>;

}  // namespace animado::fred
