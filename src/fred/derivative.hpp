// The right-hand side of y' = f(t, y), as whoever integrates sees it.
#pragma once

#include <concepts>
#include <functional>
#include <span>
#include <type_traits>

#include "fred/lanes.hpp"

namespace animado::fred {

// Refers to a callable f(t, y, rate) that puts the derivative into `rate`; whoever made it keeps it alive.
// Two words and one indirect call: what a std::function costs more is noticed where f itself takes 10 ns.
class Derivative {
 public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, Derivative> &&
           std::invocable<F&, double, std::span<const double>, std::span<double>>) Derivative(F&& f)
      : function_{const_cast<void*>(static_cast<const void*>(&f)),
                  [](void* object, double t, const double* y, double* rate, size_t size) {
                    (*static_cast<std::remove_reference_t<F>*>(object))(t, std::span(y, size),
                                                                        std::span(rate, size));
                  }} {}

  void operator()(double t, std::span<const double> y, std::span<double> rate) const {
    function_.call(function_.object, t, y.data(), rate.data(), rate.size());
  }

  const RateFunction& function() const { return function_; }

 private:
  RateFunction function_;
};

// Puts ∂f_i/∂y_j at (t, y) into jacobian[i n + j].
using Jacobian = std::function<void(double t, std::span<const double> y, std::span<double> jacobian)>;

}  // namespace animado::fred
