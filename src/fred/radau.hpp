// Radau IIA of three stages and fifth order, for stiff problems: implicit, so that steps are as long as the
// solution is smooth and not as short as its fastest decay.
//
//   z_i = h Σ_j a_ij f(t + c_j h, y + z_j),   y⁺ = y + z_3,   c = (4 − √6)/10, (4 + √6)/10, 1
//
// Hairer, Wanner, Solving ODE II (1996), IV.5 and IV.8. The stages are found by simplified Newton iteration
// with the Jacobian of the step's start; the 3n×3n system is factored as it is, where RADAU5 splits it by the
// eigenvalues of A: simpler, and as quick up to some tens of unknowns. Each step begins from z = 0, not from
// an extrapolation, so that it depends on nothing but what a checkpoint holds.
#pragma once

#include <memory>
#include <vector>

#include "fred/control.hpp"
#include "fred/derivative.hpp"
#include "fred/state_sums.hpp"

namespace animado::fred {

class Radau {
 public:
  // Derivative and Jacobian are kept and called later; the tolerance tells the iteration when to stop.
  Radau(Derivative derivative, Jacobian jacobian, std::span<const double> start, Tolerance tolerance);
  ~Radau();
  Radau(Radau&&) noexcept;

  static constexpr int kOrder = 5, kErrorOrder = 3, kStages = 3;

  std::span<const double> y() const { return y_; }
  std::span<const double> end() const { return end_; }
  int64_t evaluations() const { return evaluations_; }

  std::span<const double> rate(double t);
  void set_rate(std::span<const double> rate);
  std::span<const double> known_rate(bool at_start) const;

  // False when the iteration does not converge: try a shorter step.
  bool attempt(double t, double h);
  bool end_is_finite() const { return StateSums(end_.size()).are_finite(end_.data()); }

  // As RungeKutta::error, by an embedded formula of third order that damps stiff parts (IV.8.19 and 8.20).
  double error(const Tolerance& tolerance);

  // The collocation polynomial, of third order inside the step.
  void interpolate(double theta, std::span<double> out);

  void accept();

 private:
  struct Matrices;
  void evaluate(double t, std::span<const double> y, std::span<double> rate);
  void factor(double t, double h);
  double correct();  // one Newton correction; its norm
  double norm(std::span<const double> v) const;

  Derivative derivative_;
  Jacobian jacobian_;
  Tolerance tolerance_;
  size_t size_;
  std::vector<double> y_, end_, rate_, z_, f_, estimate_;
  std::unique_ptr<Matrices> matrices_;
  double t_ = 0, h_ = 0;
  bool knows_rate_ = false, knows_jacobian_ = false;
  int tries_ = 0;  // of this step
  int64_t evaluations_ = 0;
};

}  // namespace animado::fred
