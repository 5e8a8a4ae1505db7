#include "fred/equal_steps.hpp"

#include <algorithm>

#include "fred/radau.hpp"
#include "fred/runge_kutta.hpp"
#include "fred/symplectic.hpp"

namespace animado::fred {

int64_t EqualTimes::count(double t0, double t1, double largest, int64_t samples) {
  // A quotient that rounding lifted just above a whole number is that number: 1.1 / 0.1 asks for 11 steps.
  const double wanted = largest > 0 ? std::ceil(std::abs(t1 - t0) / largest * (1 - 0x1p-50)) : 1000;
  const double group = static_cast<double>(std::max<int64_t>(samples, 1));
  return static_cast<int64_t>(std::min(std::ceil(std::max(wanted, 1.0) / group) * group, 0x1p62));
}

int64_t EqualTimes::before(double t, int64_t most) const {
  const double last = std::ceil((t - origin) / step - kHair) - 1;
  return static_cast<int64_t>(std::clamp(last - static_cast<double>(done), 0.0, static_cast<double>(most)));
}

template <class Core>
Stepper::Outcome EqualSteps<Core>::advance(const Reach& reach) {
  whole_ = true;
  const Outcome outcome = take_whole(times_.before(reach.until, reach.most - 1));
  if (outcome != Outcome::stepped) return outcome;
  const double next = times_.after(times_.done + 1), past = (next - reach.end) / times_.step;
  whole_ = past < kHair;
  return take_step(whole_ ? times_.step : reach.end - t_, past > -kHair ? reach.end : next);
}

template <class Core>
Stepper::Outcome EqualSteps<Core>::take_whole(int64_t count) {
  return take_one_by_one(count);
}

template <class Core>
Stepper::Outcome EqualSteps<Core>::take_one_by_one(int64_t count) {
  for (; count > 0; --count) {
    const Outcome outcome = take_step(times_.step, times_.after(times_.done + 1));
    if (outcome != Outcome::stepped) return outcome;
  }
  return Outcome::stepped;
}

// All at once. Where they end in what is not finite, again and one by one, which tells where that began. What
// f throws leaves the state as it was before.
template <>
Stepper::Outcome EqualSteps<RungeKutta>::take_whole(int64_t count) {
  if (count == 0) return Outcome::stepped;
  accept_pending();
  before_.assign(core_.y().begin(), core_.y().end());
  try {
    core_.attempt(times_.origin, times_.step, times_.done, count);
  } catch (...) {
    core_.set_y(before_);
    throw;
  }
  if (core_.end_is_finite()) {
    finish_steps(count, times_.after(times_.done + count));
    return Outcome::stepped;
  }
  core_.set_y(before_);
  return take_one_by_one(count);
}

// To t.
template <class Core>
Stepper::Outcome EqualSteps<Core>::take_step(double h, double t) {
  accept_pending();
  from_ = t_;
  if (!core_.attempt(from_, h)) return Outcome::step_too_small;
  if (!core_.end_is_finite()) return Outcome::not_finite;
  finish_steps(1, t);
  return Outcome::stepped;
}

template <class Core>
void EqualSteps<Core>::accept_pending() {
  if (pending_) core_.accept();
  pending_ = false;
}

template <class Core>
void EqualSteps<Core>::finish_steps(int64_t count, double t) {
  t_ = t;
  pending_ = true;
  times_.done += count;
  steps_ += count;
}

template <class Core>
void EqualSteps<Core>::interpolate(double t, std::span<double> out) {
  if (t == t_ || !pending_) {
    std::ranges::copy(y(), out.begin());
  } else {
    core_.interpolate((t - from_) / (t_ - from_), out);
  }
}

template <class Core>
Checkpoint EqualSteps<Core>::checkpoint(bool at_start) {
  Checkpoint point;
  const bool start = at_start || !pending_;
  point.method = method_;
  point.t = start ? from_ : t_;
  point.control.step = times_.step;
  point.origin = times_.origin;
  point.steps = times_.done - (start && pending_ ? 1 : 0);
  const auto y = start ? core_.y() : core_.end();
  point.y.assign(y.begin(), y.end());
  if (const auto rate = core_.known_rate(start); !rate.empty()) point.rate.assign(rate.begin(), rate.end());
  return point;
}

template class EqualSteps<RungeKutta>;
template class EqualSteps<Symplectic>;
template class EqualSteps<Radau>;

}  // namespace animado::fred
