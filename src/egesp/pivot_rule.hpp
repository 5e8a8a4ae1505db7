// Which elements may be divided by, and what is said when none is left.
#pragma once

#include <algorithm>
#include <cstddef>

namespace animado::egesp {

struct PivotRule {
  bool complete = false;  // the largest of all remaining rows and columns; else of the remaining rows in one
                          // column (partial)
  double threshold = 0;   // T: a pivot not larger than T times the largest element of its matrix is refused

  // T for matrices of `size` = max(rows, columns); without one, what an elimination of that size loses in
  // rounding.
  double tolerance(size_t size) const {
    return threshold > 0 ? threshold : static_cast<double>(size) * 0x1p-52;
  }

  // A pivot must be larger than this. Below 2⁻¹⁰²² its reciprocal would overflow.
  double floor(size_t size, double largest) const { return std::max(largest * tolerance(size), 0x1p-1022); }
};

}  // namespace animado::egesp
