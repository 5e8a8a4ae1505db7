// Steps as long as the tolerance allows, by a method that knows its own error: fred estimates the error of a
// step that was made, and tells how long the next one may be (PI control). Nothing is computed twice to find
// out.
#pragma once

#include "controle/free_motion.hpp"

namespace animado::controle {

// Error of a step when the scene gives no `tolerance`: a thousand steps a second for 100 s add up to 1e-7 at
// the very most, and to far less as errors cancel.
constexpr double kStepTolerance = 1e-12;

class EmbeddedSteps {
 public:
  // tolerance: error of a step, absolute and relative, of the worst body.
  EmbeddedSteps(FreeMotion& motion, double tolerance);

  // How long the next step should be when rest_s are left: steps of one length that end where the rest does.
  double proposed_s(double rest_s, double most_s) const;

  // Moves `from`, the state at time_s, into `to` by step_s, or by less where the error is too large; tells by
  // how much. Throws Error diverged when no step is short enough.
  double step(const Lanes& from, double time_s, double step_s, const Lanes& to);

  // The same step once more, now to an impact inside it.
  void repeat(double step_s, const Lanes& to) { motion_.go(step_s, to); }

  // Whether the end of the last step is where the next one starts, so that its rates need not be evaluated.
  void goes_on(bool from_end) { goes_on_ = from_end; }

 private:
  std::optional<Error> attempt(double step_s, const Lanes& to);
  void take(const fred::Estimate::Reply& estimate, double step_s);

  FreeMotion& motion_;
  fred::Estimate::Request request_;  // tolerances, and the memory of the control
  double next_s_;
  bool goes_on_ = false;
};

}  // namespace animado::controle
