// The explicit Runge–Kutta methods, one row of the table a method:
//
//   k_s = f(t + c_s h, y + h Σ_{j<s} a_sj k_j),   y(t + h) ≈ y + h Σ b_s k_s
//
// Notation of Butcher, On Runge–Kutta processes of high order (1964).
#pragma once

#include <span>
#include <string>
#include <vector>

namespace animado::fred {

struct Tableau {
  std::string name, reference;
  int order;                    // of convergence
  std::vector<double> nodes;    // c
  std::vector<double> weights;  // b
  std::vector<double> matrix;   // a, (stages, stages), row-major, strictly lower

  size_t stages() const { return nodes.size(); }

  // What the derivatives are weighed with to find where stage s is evaluated; for s = stages, the end of the
  // step.
  std::span<const double> coefficients(size_t s) const {
    return s == stages() ? std::span(weights) : std::span(matrix).subspan(s * stages(), s);
  }
};

// All of them, the default first.
const std::vector<Tableau>& tableaus();

// Throws unknown_name, with the nearest name.
const Tableau& tableau_named(std::string_view name);

}  // namespace animado::fred
