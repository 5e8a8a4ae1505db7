// Where a stage of a Runge–Kutta step is evaluated, and where the step ends: out = y + h Σ a_j k_j.
#pragma once

#include <span>

#include "fred/lanes.hpp"

namespace animado::fred {

// derivatives: at least as many as the sum reads, each `state.size()` numbers, one after the other.
// out: the size of state, apart from state and derivatives.
//
// Each element's sum is taken in its order over the coefficients that are not zero, each operation rounded:
// the bits do not depend on the width of a vector register. Whether h is in the coefficients: see Sum. A
// derivative whose coefficient is zero is not read.
void combine(std::span<const double> state, std::span<const double> derivatives, const Sum& sum, double step,
             std::span<double> out);

}  // namespace animado::fred
