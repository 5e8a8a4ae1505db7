// Where functions of the solution cross zero.
//
// The signs of each function are compared at kParts + 1 points of every step; where they differ the crossing
// is narrowed down on the dense output until it lies between neighbouring numbers, or nearly (far under 1e-12
// of the time). Two crossings of one function inside one part are not seen, nor is a zero that is touched and
// not crossed.
#pragma once

#include <functional>

#include "fred/stepper.hpp"
#include "fred/vocabulary.hpp"

namespace animado::fred {

struct EventRule {
  std::function<double(double t, std::span<const double> y)> value;
  Crossing crossing = Crossing::any;
  bool terminal = false;
};

struct Occurrence {
  size_t rule = 0;
  double t = 0;
  bool rising = false;
  std::vector<double> y;  // at t
};

class EventFinder {
 public:
  explicit EventFinder(std::vector<EventRule> rules) : rules_(std::move(rules)) {}

  // Zero at the start is no crossing.
  void start(double t, std::span<const double> y);

  // What happens in the stepper's last step, in the order of time.
  std::vector<Occurrence> in_step(Stepper& stepper);

  bool is_terminal(const Occurrence& event) const { return rules_[event.rule].terminal; }

 private:
  int sign(size_t rule, Stepper& stepper, double t);
  double locate(size_t rule, Stepper& stepper, double before, double after, int sign_before);

  std::vector<EventRule> rules_;
  std::vector<int> signs_;  // −1, 0 (just met, or not known), +1
  std::vector<double> y_;   // scratch
};

}  // namespace animado::fred
