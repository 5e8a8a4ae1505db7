// What an embedded method knows about a step that was made: its error, and the solution inside it. The
// formulas are those of tableau.hpp.
#pragma once

#include <span>
#include <vector>

#include "fred/control.hpp"
#include "fred/tableau.hpp"

namespace animado::fred {

// u(θ) = y + difference (y⁺ − y) + h Σ rates_j k_j.
struct DenseWeights {
  double difference = 0;
  std::vector<double> rates;  // of all derivatives
};
DenseWeights dense_weights(const Tableau& method, double theta);

// squares: of each of the method's estimates, Σ_i ((Σ_j e_j k_j)_i / scale_i)² over n elements. The root mean
// square of one; of DOP853's two, err5² / √(err5² + 0.01 err3²) (Hairer, Nørsett, Wanner I, II.10.17).
double error_of(std::span<const double> squares, double step, size_t n);

// The same for a step that the caller made. derivatives: one after the other, each the size of state, as many
// as the method's estimates read. systems: element i belongs to system i mod `systems`, and the error is that
// of the worst of them.
double step_error(const Tableau& method, std::span<const double> state, std::span<const double> end,
                  std::span<const double> derivatives, double step, const Tolerance& tolerance,
                  size_t systems = 1);

// derivatives: all of the method's.
void dense_output(const Tableau& method, std::span<const double> state, std::span<const double> end,
                  std::span<const double> derivatives, double step, double theta, std::span<double> out);

}  // namespace animado::fred
