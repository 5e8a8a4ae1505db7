// How long a step may be ("cuidar da discretização do tempo na integração, quando necessário", the paper,
// section 3.6): by the method's error estimate, unless the scene gives a sub-step.
#pragma once

#include "controle/free_motion.hpp"

namespace animado::controle {

// A force that changes within a frame should not be stepped over.
inline constexpr double kLongestStep_s = 1.0 / 60;

// A motion that diverges in a step may do well in one of this part of it.
inline constexpr double kAfterDivergence = 0.1;

class StepSize {
 public:
  // given_s: a length that the scene fixes. tolerance: error a second, relative to 1 + |y|; chosen here when
  // missing.
  StepSize(FreeMotion& motion, size_t bodies, std::optional<double> given_s, std::optional<double> tolerance);

  // The number of equal steps to cut the interval into. A step is compared with two of half its length from
  // `state` at time_s; the largest one whose error a second, relative to 1 + |y|, stays under the tolerance
  // is taken, and none longer than most_s.
  size_t steps(const Lanes& state, double time_s, double interval_s, double most_s);

 private:
  double error_rate(const Lanes& state, double time_s, double step_s);

  FreeMotion& motion_;
  size_t bodies_;
  int order_;
  double tolerance_rate_;
  std::optional<double> given_s_;
  double last_s_;  // where the search begins
  Lanes whole_, half_, halves_;
};

}  // namespace animado::controle
