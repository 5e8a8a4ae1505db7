#include "fred/embedded.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fred/stage.hpp"
#include "fred/state_sums.hpp"

namespace animado::fred {

DenseWeights dense_weights(const Tableau& method, double theta) {
  const double rest = 1 - theta;
  DenseWeights weights{theta * (1 - rest * (1 - 2 * theta)), std::vector<double>(method.derivatives())};
  weights.rates[0] = theta * rest * rest;
  weights.rates[method.stages()] = -theta * rest * theta;
  double product = theta * rest * theta;  // θ (1 − θ) θ (1 − θ) …, the factors before F3, F4, …
  for (size_t i = 0; i < method.dense.size(); ++i) {
    product *= i % 2 == 0 ? rest : theta;
    for (size_t j = 0; j < method.derivatives(); ++j) weights.rates[j] += product * method.dense[i][j];
  }
  return weights;
}

double error_of(std::span<const double> squares, double step, size_t n) {
  const double h = std::abs(step), count = static_cast<double>(n);
  if (squares.size() == 1) return h * std::sqrt(squares[0] / count);
  const double both = squares[0] + 0.01 * squares[1];
  return both == 0 ? 0 : h * squares[0] / std::sqrt(count * both);
}

namespace {

// NaN where a system's is.
double worst_error(const Tableau& method, std::span<const double> state, std::span<const double> end,
                   std::span<const double> derivatives, double step, const Tolerance& tolerance,
                   size_t systems) {
  const size_t read = method.stages() + (method.error_reads_end() ? 1 : 0);
  const size_t estimates = method.errors.size();
  const std::vector<double> zeros(state.size());
  std::vector<double> error(state.size()), squares(systems * estimates);
  for (size_t e = 0; e < estimates; ++e) {
    combine(zeros, derivatives, sum_of(std::span(method.errors[e]).first(read)), 1, error);
    for (size_t i = 0, system = 0; i < state.size(); ++i) {
      const double scaled = error[i] / tolerance.scale(i, std::max(std::abs(state[i]), std::abs(end[i])));
      squares[system * estimates + e] += scaled * scaled;
      if (++system == systems) system = 0;
    }
  }
  double worst = 0;
  for (size_t system = 0; system < systems; ++system) {
    const double of_system =
        error_of(std::span(squares).subspan(system * estimates, estimates), step, state.size() / systems);
    if (!(of_system <= worst)) worst = of_system;
    if (std::isnan(worst)) break;
  }
  return worst;
}

}  // namespace

double step_error(const Tableau& method, std::span<const double> state, std::span<const double> end,
                  std::span<const double> derivatives, double step, const Tolerance& tolerance,
                  size_t systems) {
  assert(method.is_adaptive() && state.size() == end.size() && state.size() % systems == 0);
  if (systems > 1) return worst_error(method, state, end, derivatives, step, tolerance, systems);
  const auto squares = StateSums(state.size())
                           .square_errors(state.data(), end.data(), rows_of(derivatives, state.size()).data(),
                                          method.estimates, tolerance);
  return error_of(std::span(squares).first(method.errors.size()), step, state.size());
}

void dense_output(const Tableau& method, std::span<const double> state, std::span<const double> end,
                  std::span<const double> derivatives, double step, double theta, std::span<double> out) {
  const DenseWeights weights = dense_weights(method, theta);
  combine(state, derivatives, sum_of(weights.rates), step, out);
  for (size_t i = 0; i < out.size(); ++i) out[i] += weights.difference * (end[i] - state[i]);
}

}  // namespace animado::fred
