// A⁻¹ as the solution of A X = 1.
#pragma once

#include "egesp/gauss_jordan.hpp"

namespace animado::egesp {

// a: (n, n), row-major, used up; inverse: (n, n), apart from it. The outcome carries the determinant.
Elimination invert(std::span<double> a, std::span<double> inverse, size_t n, const PivotRule& rule);

}  // namespace animado::egesp
