// det A = ± Π a_kk of the echelon form, the sign from the exchanges of rows (and columns).
#pragma once

#include "egesp/echelon.hpp"

namespace animado::egesp {

// a: (n, n), row-major, used up. 0 where solving would refuse a pivot; infinite when it is larger than any
// double.
double determinant(std::span<double> a, size_t n, const PivotRule& rule = {});

// The determinant of a matrix that has been reduced, every pivot accepted.
double product_of_pivots(std::span<const double> reduced, size_t n, const Echelon& echelon);

}  // namespace animado::egesp
