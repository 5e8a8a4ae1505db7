// The explicit Runge–Kutta methods, one row of the table a method:
//
//   k_s = f(t + c_s h, y + h Σ_{j<s} a_sj k_j),   y(t + h) ≈ y⁺ = y + h Σ b_s k_s
//
// Notation of Butcher, On Runge–Kutta processes of high order (1964). An embedded method tells the error of
// the step, h Σ e_s k_s, and the dense output tells y inside it. Both may use, after the s stages,
//
//   k_s = f(t + h, y⁺), the first stage of the next step,   and k_{s+1}, … from extra stages, a_s likewise.
//
// Dense output, of Hairer, Nørsett, Wanner, Solving ODE I (1993), II.6: with Δ = y⁺ − y,
//
//   u(θ) = y + θ (F0 + (1−θ)(F1 + θ (F2 + (1−θ)(F3 + θ (F4 + …)))))
//   F0 = Δ,  F1 = h k_0 − Δ,  F2 = 2 Δ − h (k_0 + k_s),  F3, F4, … = h Σ d_is k_s
//
// Without d it is the cubic that takes value and slope from both ends, of order 3.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fred/lanes.hpp"

namespace animado::fred {

// Where k_s is evaluated; for s = stages the end of the step.
struct Place {
  Sum sum;
  double node;
};

struct Tableau {
  std::string name, reference;
  size_t number;                // in EveryMethod and tableaus()
  int order;                    // of convergence
  std::vector<double> nodes;    // c
  std::vector<double> weights;  // b
  std::vector<double> matrix;   // a, (stages, stages), row-major, strictly lower

  int error_order = 0;                           // of the estimate: it shrinks with h^(error_order + 1)
  std::vector<std::vector<double>> errors = {};  // e, (stages + 1) each: none, one, or the two of DOP853

  int dense_order = 3;
  std::vector<double> extra_nodes = {};                // c of k_{s+1}, …
  std::vector<std::vector<double>> extra_matrix = {};  // a of them, row i over (stages + 1 + i) derivatives
  std::vector<std::vector<double>> dense = {};         // d, over all derivatives

  // The same numbers as the kernels read them.
  std::vector<Place> places = {};   // of each derivative
  std::vector<Sum> estimates = {};  // of the error; all read the same derivatives

  size_t stages() const { return nodes.size(); }
  size_t derivatives() const { return stages() + 1 + extra_nodes.size(); }
  bool is_adaptive() const { return !errors.empty(); }
  // Whether the error needs f(t + h, y⁺), which a refused step would not.
  bool error_reads_end() const { return !errors.empty() && errors[0][stages()] != 0; }

  // What the derivatives are weighed with to find where k_s is evaluated: its row of the matrix; for s =
  // stages the weights, since k_s belongs to the end of the step; then the extra rows.
  std::span<const double> coefficients(size_t s) const {
    if (s > stages()) return extra_matrix[s - stages() - 1];
    return s == stages() ? std::span(weights) : std::span(matrix).subspan(s * stages(), s);
  }
  double node(size_t s) const {
    return s > stages() ? extra_nodes[s - stages() - 1] : s == stages() ? 1 : nodes[s];
  }
};

// All of them, the default first.
const std::vector<Tableau>& tableaus();

}  // namespace animado::fred
