#include "egesp/lu.hpp"

#include <cassert>
#include <cmath>

#include "egesp/determinant.hpp"
#include "egesp/triangles.hpp"

namespace animado::egesp {
namespace {

// to[order[k]] ← from[k], a row of m numbers each; without an order nothing moves.
void scatter(std::span<double> rows, size_t m, const std::vector<size_t>& order) {
  if (order.empty()) return;
  const std::vector<double> from(rows.begin(), rows.end());
  for (size_t k = 0; k < order.size(); ++k)
    std::ranges::copy(std::span(from).subspan(k * m, m), rows.subspan(order[k] * m, m).begin());
}

// to[k] ← from[order[k]]
void gather(std::span<double> rows, size_t m, const std::vector<size_t>& order) {
  if (order.empty()) return;
  const std::vector<double> from(rows.begin(), rows.end());
  for (size_t k = 0; k < order.size(); ++k)
    std::ranges::copy(std::span(from).subspan(order[k] * m, m), rows.subspan(k * m, m).begin());
}

}  // namespace

Lu::Lu(std::vector<double> a, size_t n, const PivotRule& rule, InstructionSet instructions)
    : n_(n), instructions_(instructions), factors_(std::move(a)) {
  echelon_ = reduce_to_echelon(factors_, n, n, {}, 0, rule, instructions);
}

double Lu::determinant() const {
  return factored() ? product_of_pivots(factors_, n_, echelon_) : 0.0;
}

double Lu::largest_factor() const {
  double largest = 0;
  for (size_t i = 0; i < n_; ++i) {
    for (size_t j = i; j < n_; ++j) largest = std::max(largest, std::abs(factors_[i * n_ + j]));
  }
  return largest;
}

size_t Lu::bytes() const {
  return factors_.size() * sizeof(double) + (echelon_.rows.size() + echelon_.columns.size()) * sizeof(size_t);
}

// P A Q (Qᵀ x) = P b
void Lu::solve(std::span<double> b, size_t m) const {
  assert(factored());
  gather(b, m, echelon_.rows);
  substitute_downward(factors_, n_, b, m, instructions_);
  substitute_upward(factors_, n_, b, m, instructions_);
  scatter(b, m, echelon_.columns);
}

// (P A Q)ᵀ (P x) = Qᵀ b
void Lu::solve_transposed(std::span<double> b) const {
  assert(factored());
  gather(b, 1, echelon_.columns);
  substitute_transposed_downward(factors_, n_, b);
  substitute_transposed_upward(factors_, n_, b);
  scatter(b, 1, echelon_.rows);
}

}  // namespace animado::egesp
