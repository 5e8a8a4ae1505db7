// A method at work on one problem, whatever kind it is: it takes one step after the other, and says where the
// solution is inside the last one.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "fred/control.hpp"

namespace animado::fred {

// From it an integration goes on to the same bits: the start of a step that neither the end nor an event cut
// short.
struct Checkpoint {
  std::string method;
  double t = 0;
  std::vector<double> y, rate;  // rate: f(t, y), empty where it is not known
  StepControl::Memory control;  // of adaptive steps; control.step is the length of equal ones too
  double origin = 0;            // equal steps: t = origin + steps · step
  int64_t steps = 0;
  double reported_t = 0;  // samples and events up to here were told before
};

class Stepper {
 public:
  enum class Outcome { stepped, step_too_small, not_finite };

  virtual ~Stepper() = default;

  // How far to go before somebody looks: towards `end`, which the last step meets but does not pass, until a
  // step reaches `until` or `most` were taken.
  struct Reach {
    double end, until;
    int64_t most;
  };

  // At least one step. The one that is not `stepped` is the last, and has not changed the state.
  virtual Outcome advance(const Reach& reach) = 0;
  Outcome step(double end) { return advance({end, end, 1}); }
  int64_t steps() const { return steps_; }  // taken

  // The last step: its start, its end. Before the first both are the start.
  double from() const { return from_; }
  double t() const { return t_; }
  virtual std::span<const double> y() const = 0;  // at t()

  // The solution at `t` between from() and t().
  virtual void interpolate(double t, std::span<double> out) = 0;

  // The start of the last step, or its end. The end only where whole() says that the step was not cut short.
  virtual Checkpoint checkpoint(bool at_start) = 0;
  virtual bool whole() const = 0;

  virtual int64_t evaluations() const = 0;
  int64_t refused() const { return refused_; }

 protected:
  // A step of which time does not notice enough: some digits of it must be left.
  static bool is_too_small(double step, double t) {
    constexpr double kLeast = 16 * std::numeric_limits<double>::epsilon();
    return std::abs(step) <= kLeast * std::abs(t) || std::abs(step) < std::numeric_limits<double>::min();
  }

  double from_ = 0, t_ = 0;
  int64_t steps_ = 0, refused_ = 0;
};

}  // namespace animado::fred
