#include "egesp/echelon.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

#include "egesp/blocked_kernels.hpp"

namespace animado::egesp {
namespace {

struct Sweep {
  std::span<double> a;
  size_t rows, columns;
  std::span<double> b;
  size_t right_sides;
  Echelon echelon;

  double* row(size_t i) const { return a.data() + i * columns; }
  double* right(size_t i) const { return b.data() + i * right_sides; }
};

double largest_element(std::span<const double> a) {
  double largest = 0;
  for (double v : a) largest = std::max(largest, std::abs(v));
  return largest;
}

void exchange_rows(Sweep& s, size_t i, size_t k) {
  if (i == k) return;
  std::swap_ranges(s.row(i), s.row(i) + s.columns, s.row(k));
  std::swap_ranges(s.right(i), s.right(i) + s.right_sides, s.right(k));
  std::swap(s.echelon.rows[i], s.echelon.rows[k]);
  s.echelon.odd = !s.echelon.odd;
}

void exchange_columns(Sweep& s, size_t j, size_t k) {
  if (j == k) return;
  for (size_t i = 0; i < s.rows; ++i) std::swap(s.row(i)[j], s.row(i)[k]);
  std::swap(s.echelon.columns[j], s.echelon.columns[k]);
  s.echelon.odd = !s.echelon.odd;
}

size_t pivot_row(const Sweep& s, size_t k) {
  size_t best = k;
  for (size_t i = k + 1; i < s.rows; ++i) {
    if (std::abs(s.row(i)[k]) > std::abs(s.row(best)[k])) best = i;
  }
  return best;
}

std::pair<size_t, size_t> pivot_row_and_column(const Sweep& s, size_t k) {
  std::pair best{k, k};
  double largest = std::abs(s.row(k)[k]);
  for (size_t i = k; i < s.rows; ++i) {
    for (size_t j = k; j < s.columns; ++j) {
      if (std::abs(s.row(i)[j]) > largest) largest = std::abs(s.row(i)[j]), best = {i, j};
    }
  }
  return best;
}

// target −= factor · source
void subtract(double* target, double factor, const double* source, size_t count) {
  for (size_t j = 0; j < count; ++j) target[j] -= factor * source[j];
}

// Stores the factors of column k and applies them to the columns beside it and to B.
void eliminate_column(Sweep& s, size_t k) {
  const double* pivot = s.row(k);
  const double inverse = 1.0 / pivot[k];
  for (size_t i = k + 1; i < s.rows; ++i) {
    double* a = s.row(i);
    const double factor = a[k] *= inverse;
    subtract(a + k + 1, factor, pivot + k + 1, s.columns - k - 1);
    subtract(s.right(i), factor, s.right(k), s.right_sides);
  }
}

void sweep_plainly(Sweep& s, bool complete, double floor) {
  for (size_t k = 0; k < std::min(s.rows, s.columns); ++k) {
    const auto [i, j] = complete ? pivot_row_and_column(s, k) : std::pair{pivot_row(s, k), k};
    if (!(std::abs(s.row(i)[j]) > floor)) return;
    exchange_rows(s, i, k);
    if (complete) exchange_columns(s, j, k);
    eliminate_column(s, k);
    ++s.echelon.pivots;
  }
}

void sweep_in_blocks(Sweep& s, bool complete, double floor, const BlockedKernels& kernels) {
  AlignedNumbers scratch(scratch_numbers(s.rows));
  Reduction reduction{s.a.data(),
                      s.rows,
                      s.columns,
                      s.b.data(),
                      s.right_sides,
                      floor,
                      s.echelon.rows.data(),
                      s.echelon.columns.data(),
                      scratch.data(),
                      0,
                      false};
  (complete ? kernels.eliminate_complete : kernels.eliminate)(reduction);
  s.echelon.pivots = reduction.pivots;
  s.echelon.odd = reduction.odd;
}

std::vector<size_t> counted(size_t count) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  return order;
}

}  // namespace

Echelon reduce_to_echelon(std::span<double> a, size_t rows, size_t columns, std::span<double> b,
                          size_t right_sides, const PivotRule& rule, InstructionSet instructions) {
  assert(a.size() == rows * columns && b.size() == rows * right_sides);
  Sweep sweep{a, rows, columns, b, right_sides, {}};
  sweep.echelon.rows = counted(rows);
  if (rule.complete) sweep.echelon.columns = counted(columns);
  const double floor = rule.floor(std::max(rows, columns), largest_element(a));
  if (instructions == InstructionSet::scalar || std::max(rows, columns) <= kPlain) {
    sweep_plainly(sweep, rule.complete, floor);
  } else {
    sweep_in_blocks(sweep, rule.complete, floor, blocked_kernels(instructions));
  }
  return std::move(sweep.echelon);
}

}  // namespace animado::egesp
