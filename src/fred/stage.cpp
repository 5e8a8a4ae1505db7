#include "fred/stage.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "fred/state_sums.hpp"

namespace animado::fred {

void combine(std::span<const double> state, std::span<const double> derivatives,
             std::span<const double> coefficients, double step, std::span<double> out) {
  assert(out.size() == state.size() && derivatives.size() >= coefficients.size() * state.size());
  if (std::ranges::all_of(coefficients, [](double a) { return a == 0; })) {
    std::ranges::copy(state, out.begin());
    return;
  }
  const StateSums sums(state.size());
  sums.combine(state.data(), rows_of(derivatives, state.size()).data(), sum_of(coefficients), step,
               out.data());
}

}  // namespace animado::fred
