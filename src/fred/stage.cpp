#include "fred/stage.hpp"

#include <algorithm>
#include <cassert>

#include "fred/state_sums.hpp"

namespace animado::fred {

void combine(std::span<const double> state, std::span<const double> derivatives, const Sum& sum, double step,
             std::span<double> out) {
  assert(out.size() == state.size());
  if (sum.coefficients[0] == 0) {  // it has no term
    std::ranges::copy(state, out.begin());
    return;
  }
  assert(derivatives.size() >= (sum.rows[sum.count - 1] + size_t{1}) * state.size());
  const StateSums sums(state.size());
  sums.combine(state.data(), rows_of(derivatives, state.size()).data(), sum, step, out.data());
}

}  // namespace animado::fred
