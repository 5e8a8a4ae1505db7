#include "fred/integrate.hpp"

#include <algorithm>
#include <chrono>

namespace animado::fred {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int64_t kStepsALook = 64;  // at the clock: it costs as much as a short step
constexpr std::chrono::milliseconds kAsk(100);

class Run {
 public:
  Run(Stepper& stepper, const Goal& goal)
      : stepper_(stepper), goal_(goal), finder_(goal.events), row_(stepper.y().size()) {}

  Solution go() {
    direction_ = goal_.t1 < stepper_.t() ? -1 : 1;
    reported_ = goal_.reported_t.value_or(stepper_.t());
    const bool fresh = !goal_.reported_t;
    while (next_ < goal_.times.size() &&
           (fresh ? is_before(goal_.times[next_], reported_) : !is_before(reported_, goal_.times[next_]))) {
      ++next_;
    }
    sample_until(stepper_.t());
    finder_.start(stepper_.t(), stepper_.y());
    solution_.stop = advance();
    finish();
    return std::move(solution_);
  }

 private:
  bool is_before(double a, double b) const { return direction_ * (a - b) < 0; }

  Stop advance() {
    while (is_before(stepper_.t(), goal_.t1)) {
      if (solution_.steps == goal_.most_steps) return Stop::step_limit;
      if (solution_.steps % kStepsALook == 0) {
        if (const auto stop = look_at_clock()) return *stop;
      }
      const int64_t before = stepper_.steps();
      const auto outcome = stepper_.advance(reach());
      solution_.steps += stepper_.steps() - before;
      if (outcome == Stepper::Outcome::step_too_small) return Stop::step_too_small;
      if (outcome == Stepper::Outcome::not_finite) return Stop::not_finite;
      if (const auto ended = tell_step()) return *ended;
    }
    return Stop::end;
  }

  // To the next look: at events in every step, at a sample, at the limit or the clock.
  Stepper::Reach reach() const {
    const bool sampled = next_ < goal_.times.size() && is_before(goal_.times[next_], goal_.t1);
    const int64_t to_clock = kStepsALook - solution_.steps % kStepsALook;
    return {goal_.t1, sampled ? goal_.times[next_] : goal_.t1,
            goal_.events.empty() ? std::min(to_clock, goal_.most_steps - solution_.steps) : 1};
  }

  // Samples and events of the last step.
  std::optional<Stop> tell_step() {
    if (!goal_.events.empty()) {
      for (Occurrence& event : finder_.in_step(stepper_)) {
        if (!is_before(reported_, event.t)) continue;
        sample_until(event.t);
        solution_.events.push_back(std::move(event));
        if (!finder_.is_terminal(solution_.events.back())) continue;
        stopped_inside_ = true;
        return Stop::event;
      }
    }
    sample_until(stepper_.t());
    return {};
  }

  void sample_until(double t) {
    while (next_ < goal_.times.size() && !is_before(t, goal_.times[next_])) sample(goal_.times[next_++]);
  }

  void sample(double t) {
    stepper_.interpolate(t, row_);
    solution_.rows.push_back(t);
    solution_.rows.insert(solution_.rows.end(), row_.begin(), row_.end());
  }

  std::optional<Stop> look_at_clock() {
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - start_).count() > goal_.most_time_s) return Stop::time_limit;
    if (!goal_.go_on || now - asked_ < kAsk) return {};
    asked_ = now;
    if (!goal_.go_on(stepper_.t(), solution_.steps)) return Stop::cancelled;
    return {};
  }

  void finish() {
    if (stopped_inside_) {
      solution_.t = solution_.events.back().t;
      solution_.y = solution_.events.back().y;
    } else {
      solution_.t = stepper_.t();
      solution_.y.assign(stepper_.y().begin(), stepper_.y().end());
    }
    solution_.checkpoint = stepper_.checkpoint(stopped_inside_ || !stepper_.whole());
    solution_.checkpoint.reported_t = is_before(reported_, solution_.t) ? solution_.t : reported_;
  }

  Stepper& stepper_;
  const Goal& goal_;
  EventFinder finder_;
  std::vector<double> row_;
  Solution solution_;
  double direction_ = 1, reported_ = 0;
  size_t next_ = 0;  // sample
  bool stopped_inside_ = false;
  Clock::time_point start_ = Clock::now(), asked_ = start_;
};

}  // namespace

std::vector<double> even_times(double t0, double t1, int64_t count) {
  std::vector<double> times;
  for (int64_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    times.push_back(i + 1 == count ? t1 : t0 + share * (t1 - t0));
  }
  return times;
}

Solution integrate(Stepper& stepper, const Goal& goal) {
  return Run(stepper, goal).go();
}

}  // namespace animado::fred
