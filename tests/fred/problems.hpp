// Problems with known solutions, and how the tests put a method to work on them.
#pragma once

#include <cmath>
#include <vector>

#include "fred/integrate.hpp"
#include "fred/methods.hpp"

namespace animado::fred {

using Function = std::function<void(double, std::span<const double>, std::span<double>)>;

// ∂f/∂y by differences: as exact as Newton's iteration needs.
inline Jacobian differences_of(const Function& f) {
  return [f](double t, std::span<const double> y, std::span<double> jacobian) {
    const size_t n = y.size();
    std::vector<double> moved(y.begin(), y.end()), rate(n), there(n);
    f(t, y, rate);
    for (size_t j = 0; j < n; ++j) {
      const double step = 1e-8 * (1 + std::abs(y[j]));
      moved[j] = y[j] + step;
      f(t, moved, there);
      for (size_t i = 0; i < n; ++i) jacobian[i * n + j] = (there[i] - rate[i]) / step;
      moved[j] = y[j];
    }
  };
}

// The function must outlive the problem. Of a separable one the first half of the unknowns are positions.
inline Problem problem_of(Function& f, std::vector<double> start, double t0 = 0) {
  Problem problem{f, t0, std::move(start), differences_of(f), {}};
  const size_t n = problem.y.size();
  problem.positions = [n] {
    std::vector<bool> positions(n);
    for (size_t i = 0; i < n / 2; ++i) positions[i] = true;
    return positions;
  };
  return problem;
}

inline Solution in_equal_steps(const std::string& method, Function f, std::vector<double> start, double t1,
                               int64_t steps) {
  const auto stepper =
      equal_stepper(method_named(method), problem_of(f, std::move(start)), t1 / static_cast<double>(steps));
  Goal goal;
  goal.t1 = t1;
  return integrate(*stepper, goal);
}

inline Solution adaptively(const std::string& method, Function f, std::vector<double> start, double t1,
                           double tolerance, Goal goal = {}) {
  const Tolerance both({tolerance}, {tolerance}, start.size());
  const auto stepper = adaptive_stepper(method_named(method), problem_of(f, std::move(start)), {both, 0});
  goal.t1 = t1;
  return integrate(*stepper, goal);
}

inline double distance(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum = std::hypot(sum, a[i] - b[i]);
  return sum;
}

}  // namespace animado::fred
