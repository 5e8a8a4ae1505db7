// Steps of one length, by any method.
#pragma once

#include "fred/stepper.hpp"

namespace animado::fred {

constexpr double kHair = 0.01;  // of a step: what rounding leaves is shorter

// The times of equal steps: origin + i · step, and t1 exactly where they end.
struct EqualTimes {
  double origin = 0, step = 0;
  int64_t done = 0;  // steps, when it begins

  double after(int64_t steps) const { return origin + static_cast<double>(steps) * step; }

  // How many of the next `most` steps end before t. One that rounding put beside it does not.
  int64_t before(double t, int64_t most) const;

  // The fewest equal steps from t0 to t1 that are no longer than `largest` (0: a thousandth of the interval),
  // and a multiple of `samples`, so that these fall on ends of steps.
  static int64_t count(double t0, double t1, double largest, int64_t samples);
};

// Core: RungeKutta, Symplectic or Radau.
template <class Core>
class EqualSteps : public Stepper {
 public:
  EqualSteps(Core core, std::string method, const EqualTimes& times)
      : core_(std::move(core)), method_(std::move(method)), times_(times) {
    from_ = t_ = times_.after(times_.done);
  }

  // Goes on from a checkpoint; the core was made with its state.
  void resume(const Checkpoint& from) {
    if (!from.rate.empty()) core_.set_rate(from.rate);
  }

  Outcome advance(const Reach& reach) override;
  std::span<const double> y() const override { return pending_ ? core_.end() : core_.y(); }
  void interpolate(double t, std::span<double> out) override;
  Checkpoint checkpoint(bool at_start) override;
  bool whole() const override { return whole_; }
  int64_t evaluations() const override { return core_.evaluations(); }

 private:
  Outcome take_whole(int64_t count);
  Outcome take_one_by_one(int64_t count);
  Outcome take_step(double h, double t);
  void accept_pending();
  void finish_steps(int64_t count, double t);

  Core core_;
  std::string method_;
  EqualTimes times_;
  std::vector<double> before_;  // what is tried at once
  bool pending_ = false, whole_ = true;
};

}  // namespace animado::fred
