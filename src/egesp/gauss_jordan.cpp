#include "egesp/gauss_jordan.hpp"

#include <cassert>
#include <limits>
#include <vector>

#include "base/finite.hpp"
#include "egesp/determinant.hpp"
#include "egesp/triangles.hpp"

namespace animado::egesp {
namespace {

// Row k of the form belongs to unknown columns[k].
void restore_order(std::span<double> b, size_t m, const std::vector<size_t>& columns) {
  const std::vector<double> reduced(b.begin(), b.end());
  for (size_t k = 0; k < columns.size(); ++k) {
    std::copy_n(reduced.begin() + static_cast<ptrdiff_t>(k * m), m,
                b.begin() + static_cast<ptrdiff_t>(columns[k] * m));
  }
}

}  // namespace

Elimination gauss_jordan(std::span<double> a, std::span<double> b, size_t n, size_t m, const PivotRule& rule,
                         InstructionSet instructions) {
  const Echelon echelon = reduce_to_echelon(a, n, n, b, m, rule, instructions);
  if (echelon.pivots < n) return {echelon.pivots, false, 0};
  substitute_upward(a, n, b, m, instructions);
  if (rule.complete) restore_order(b, m, echelon.columns);
  return {n, all_finite(b), product_of_pivots(a, n, echelon)};
}

}  // namespace animado::egesp
