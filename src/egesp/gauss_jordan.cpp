#include "egesp/gauss_jordan.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "egesp/determinant.hpp"

namespace animado::egesp {
namespace {

// Row by row, so that A is read along its rows; b_i still meets its terms in the order k = n−1, n−2, …
void sweep_upward(std::span<const double> a, std::span<double> b, size_t n, size_t m) {
  for (size_t i = n; i-- > 0;) {
    double* x = b.data() + i * m;
    for (size_t k = n; k-- > i + 1;) {
      for (size_t c = 0; c < m; ++c) x[c] -= a[i * n + k] * b[k * m + c];
    }
    const double inverse = 1.0 / a[i * n + i];
    for (size_t c = 0; c < m; ++c) x[c] *= inverse;
  }
}

// Row k of the form belongs to unknown columns[k].
void restore_order(std::span<double> b, size_t m, const std::vector<size_t>& columns) {
  const std::vector<double> reduced(b.begin(), b.end());
  for (size_t k = 0; k < columns.size(); ++k) {
    std::copy_n(reduced.begin() + static_cast<ptrdiff_t>(k * m), m,
                b.begin() + static_cast<ptrdiff_t>(columns[k] * m));
  }
}

}  // namespace

Elimination gauss_jordan(std::span<double> a, std::span<double> b, size_t n, size_t m,
                         const PivotRule& rule) {
  const Echelon echelon = reduce_to_echelon(a, n, n, b, m, rule);
  if (echelon.pivots < n) return {echelon.pivots, false, 0};
  sweep_upward(a, b, n, m);
  if (rule.complete) restore_order(b, m, echelon.columns);
  const bool finite = std::ranges::all_of(b, [](double x) { return std::isfinite(x); });
  return {n, finite, product_of_pivots(a, n, echelon)};
}

}  // namespace animado::egesp
