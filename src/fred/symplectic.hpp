// Steps for separable problems, q' = f(p, t) and p' = g(q, t): momenta and positions in turn, each moved by
// what the other has become. They keep the symplectic form, so that the energy of a Hamiltonian stays near
// what it was for ever.
//
//   symplectic Euler:   p⁺ = p + h g(q, t),           q⁺ = q + h f(p⁺, t + h)                      order 1
//   Störmer–Verlet:     p½ = p + h/2 g(q, t),         q⁺ = q + h f(p½, t + h/2),
//                       p⁺ = p½ + h/2 g(q⁺, t + h)                                                order 2
//
// Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), I.1.2 and I.1.4. Between the ends of a step
// the solution is the cubic of its values and slopes.
#pragma once

#include <vector>

#include "fred/derivative.hpp"
#include "fred/state_sums.hpp"

namespace animado::fred {

enum class SymplecticMethod { euler, verlet };

class Symplectic {
 public:
  // position[i]: element i is one of q, else one of p.
  Symplectic(SymplecticMethod method, Derivative derivative, std::span<const double> start,
             std::vector<bool> position);

  std::span<const double> y() const { return y_; }
  std::span<const double> end() const { return end_; }
  int64_t evaluations() const { return evaluations_; }
  std::span<const double> known_rate(bool) const {
    return {};
  }  // each of the two is evaluated where it is needed
  void set_rate(std::span<const double>) {}

  bool attempt(double t, double h);
  bool end_is_finite() const { return StateSums(end_.size()).are_finite(end_.data()); }
  void interpolate(double theta, std::span<double> out);
  void accept() { std::swap(y_, end_); }

 private:
  void evaluate(double t, std::span<const double> y, std::vector<double>& rate);
  void move(bool positions, double h);  // of end_, by rate_

  SymplecticMethod method_;
  Derivative derivative_;
  std::vector<bool> position_;
  std::vector<double> y_, end_, rate_, start_rate_, end_rate_;
  double t_ = 0, h_ = 0;
  bool knows_rates_ = false;
  int64_t evaluations_ = 0;
};

}  // namespace animado::fred
