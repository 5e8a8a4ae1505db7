// y' = f(t, y) to a given time, or until something stops it.
#pragma once

#include <functional>
#include <optional>

#include "fred/events.hpp"
#include "fred/stepper.hpp"

namespace animado::fred {

struct Goal {
  double t1 = 1;
  std::vector<double> times = {};  // of samples, in the direction of t1
  std::vector<EventRule> events = {};
  int64_t most_steps = std::numeric_limits<int64_t>::max();
  double most_time_s = std::numeric_limits<double>::infinity();  // on the clock
  std::optional<double> reported_t = {};  // samples and events up to there were told before
  // Asked about ten times a second; false cancels.
  std::function<bool(double t, int64_t steps)> go_on = {};
};

struct Solution {
  Stop stop = Stop::end;
  double t = 0;              // where it stopped
  std::vector<double> y;     // there
  std::vector<double> rows;  // (samples, 1 + size of y): t and y at each time that was reached
  std::vector<Occurrence> events;
  int64_t steps = 0;  // taken in this call
  Checkpoint checkpoint;
};

// Times of `count` even samples from t0 to t1, both among them.
std::vector<double> even_times(double t0, double t1, int64_t count);

Solution integrate(Stepper& stepper, const Goal& goal);

}  // namespace animado::fred
