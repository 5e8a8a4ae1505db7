// Steps as long as the tolerance allows, by a method that knows its error.
#pragma once

#include "fred/stepper.hpp"

namespace animado::fred {

struct AdaptiveMethod {
  std::string name;
  int order = 0, error_order = 0;
};

// Core: RungeKutta with an embedded method, or Radau.
template <class Core>
class AdaptiveSteps : public Stepper {
 public:
  // From (t, the state of the core) on. largest: of a step, 0 for any. The derivative is called later.
  AdaptiveSteps(Core core, AdaptiveMethod method, Derivative derivative, double t, Tolerance tolerance,
                double largest);

  // Goes on from a checkpoint; the core was made with its state.
  void resume(const Checkpoint& from);

  Outcome advance(const Reach& reach) override;
  std::span<const double> y() const override { return pending_ ? core_.end() : core_.y(); }
  void interpolate(double t, std::span<double> out) override;
  Checkpoint checkpoint(bool at_start) override;
  bool whole() const override { return whole_; }
  int64_t evaluations() const override { return core_.evaluations() + trial_evaluations_; }

 private:
  Outcome take_step(double end);
  void choose_first(double end);
  Outcome failure();

  Core core_;
  AdaptiveMethod method_;
  Derivative derivative_;
  Tolerance tolerance_;
  StepControl control_;
  StepControl::Memory before_;  // at the start of the last step
  double largest_;
  bool pending_ = false;  // the last step stays where it can be interpolated until the next one begins
  bool whole_ = true;
  int64_t trial_evaluations_ = 0;
};

}  // namespace animado::fred
