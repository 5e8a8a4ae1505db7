// One step of an explicit Runge–Kutta method, with its error and what lies inside it.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "fred/control.hpp"
#include "fred/derivative.hpp"
#include "fred/state_sums.hpp"
#include "fred/tableau.hpp"

namespace animado::fred {

class RungeKutta {
 public:
  // The derivative is kept and called later.
  RungeKutta(const Tableau& method, Derivative derivative, std::span<const double> start);

  size_t size() const { return size_; }
  const Tableau& method() const { return method_; }
  std::span<const double> y() const { return {y_, size_}; }      // at the start of the step
  std::span<const double> end() const { return {end_, size_}; }  // where the last try arrived
  int64_t evaluations() const { return evaluations_; }

  // f at the start; evaluated when it is not known yet.
  std::span<const double> rate(double t);
  void set_rate(std::span<const double> rate);
  void set_y(std::span<const double> y);  // goes back to it; f is not known there
  // f at the start, or at the end of the last try; empty where it was not needed yet.
  std::span<const double> known_rate(bool at_start) const;

  // Computes the end of the step from (t, y), which always works. It may be tried again with another length.
  bool attempt(double t, double h) {
    attempt(t, h, 0, 1);
    return true;
  }
  // The end of the last of `count` steps, the first of them from (origin + first · h, y). Nobody looks at
  // what is between, but a number that is not finite stays so.
  void attempt(double origin, double h, int64_t first, int64_t count);
  bool end_is_finite() const { return lanes_.kernels.are_finite(end_, 0, lanes_.end); }

  // Of the last try: its estimated error over the tolerance, root mean square over the elements (the DOP853
  // combination of two estimates where the method has them). At most 1 is acceptable.
  double error(const Tolerance& tolerance);

  // The solution at t + θ h, θ in [0, 1], of the last try. May need further evaluations, once a try.
  void interpolate(double theta, std::span<double> out);

  // The end becomes the start.
  void accept() {
    std::swap(y_, end_);
    std::swap(k_[0], k_[stages_]);
    knows_rate_ = knows_end_;
    knows_end_ = knows_dense_ = false;
  }

 private:
  void evaluate(size_t s, double t, const double* at);
  void combine(const Sum& sum);  // into the stage
  void evaluate_stage(size_t s);
  void evaluate_end();
  void prepare_dense();

  const Tableau& method_;
  Derivative derivative_;
  const Place* places_;
  size_t size_, stages_;
  StateSums errors_;
  WholeLanes lanes_;
  std::unique_ptr<double[], void (*)(void*)> memory_;
  std::array<double*, kMostDerivatives> k_ = {};
  double *y_, *end_, *stage_;
  double t_ = 0, h_ = 0;
  bool knows_rate_ = false, knows_end_ = false, knows_dense_ = false;
  int64_t evaluations_ = 0;
};

}  // namespace animado::fred
