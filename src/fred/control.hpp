// How long a step may be: error per step against a tolerance.
#pragma once

#include <span>
#include <vector>

#include "fred/derivative.hpp"

namespace animado::fred {

// The error of element i is measured in units of absolute_i + relative_i max(|y_i| before, after).
struct Tolerance {
  std::vector<double> absolute, relative;  // one of all elements, or one of each

  // absolute > 0, relative ≥ 0; each one number, or one of each of `size` elements.
  Tolerance(std::vector<double> absolute_of, std::vector<double> relative_of, size_t size);

  size_t stride() const { return absolute.size() == 1 ? 0 : 1; }
  double scale(size_t i, double magnitude) const {
    return absolute[i * stride()] + relative[i * stride()] * magnitude;
  }
};

constexpr double kLeastError = 1e-4;  // remembered of a step that was far too good

// Chooses the next step from the errors of the last two, the shorter of what two rules allow: PI control of
// Gustafsson, in the form of Hairer, Nørsett, Wanner, Solving ODE I (1993), II.4, and II (1996), IV.2; and
// his prediction that the error's constant goes on to grow as it did over the last step (the same, IV.8.25),
// which sees a close approach coming, where nearly every refused try is spared.
class StepControl {
 public:
  struct Memory {                // what a checkpoint keeps
    double step = 0;             // the next one, signed
    double error = kLeastError;  // of the last step that was accepted
    double taken = 0;            // its length; 0 where there was none: nothing is predicted
    bool refused = false;        // the last try was refused
  };

  explicit StepControl(int error_order);

  Memory& memory() { return memory_; }
  const Memory& memory() const { return memory_; }

  // Told the error of a try (at most 1 is acceptable; NaN is not), decides, and chooses the next length.
  bool accept(double error, double tried);

 private:
  double order_;  // of the error's growth with the step
  Memory memory_;
};

// A first step (Hairer, Nørsett, Wanner I, II.4): costs one evaluation. rate: f(t, y). towards: signed
// distance to the end, never exceeded.
double first_step(const Derivative& derivative, double t, std::span<const double> y,
                  std::span<const double> rate, double towards, int order, const Tolerance& tolerance);

}  // namespace animado::fred
