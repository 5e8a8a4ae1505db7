#include "egesp/echelon.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace animado::egesp {
namespace {

constexpr size_t kPanel =
    32;  // columns eliminated before the rest of the matrix is touched: a panel's rows stay in the L2 cache
constexpr size_t kTile = 512;  // columns of the rest that one pass works on: 32 rows of it are 128 KiB

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

// Stores the factors of column k and applies them to the columns up to `end` and to B.
void eliminate_column(Sweep& s, size_t k, size_t end) {
  const double* pivot = s.row(k);
  const double inverse = 1.0 / pivot[k];
  for (size_t i = k + 1; i < s.rows; ++i) {
    double* a = s.row(i);
    const double factor = a[k] *= inverse;
    subtract(a + k + 1, factor, pivot + k + 1, end - k - 1);
    subtract(s.right(i), factor, s.right(k), s.right_sides);
  }
}

// Applies the factors of the columns first … last − 1 to the columns from `last` on, a tile at a time.
void update_rest(Sweep& s, size_t first, size_t last) {
  for (size_t tile = last; tile < s.columns; tile += kTile) {
    const size_t width = std::min(kTile, s.columns - tile);
    for (size_t i = first + 1; i < s.rows; ++i) {
      for (size_t k = first; k < std::min(i, last); ++k)
        subtract(s.row(i) + tile, s.row(i)[k], s.row(k) + tile, width);
    }
  }
}

void sweep_partial(Sweep& s, double floor) {
  const size_t steps = std::min(s.rows, s.columns);
  for (size_t first = 0; first < steps; first += kPanel) {
    const size_t last = std::min(first + kPanel, steps);
    for (size_t k = first; k < last; ++k) {
      const size_t i = pivot_row(s, k);
      if (!(std::abs(s.row(i)[k]) > floor)) return;
      exchange_rows(s, i, k);
      eliminate_column(s, k, last);
      ++s.echelon.pivots;
    }
    update_rest(s, first, last);
  }
}

void sweep_complete(Sweep& s, double floor) {
  s.echelon.columns.resize(s.columns);
  std::iota(s.echelon.columns.begin(), s.echelon.columns.end(), size_t{0});
  for (size_t k = 0; k < std::min(s.rows, s.columns); ++k) {
    const auto [i, j] = pivot_row_and_column(s, k);
    if (!(std::abs(s.row(i)[j]) > floor)) return;
    exchange_rows(s, i, k);
    exchange_columns(s, j, k);
    eliminate_column(s, k, s.columns);
    ++s.echelon.pivots;
  }
}

}  // namespace

Echelon reduce_to_echelon(std::span<double> a, size_t rows, size_t columns, std::span<double> b,
                          size_t right_sides, const PivotRule& rule) {
  assert(a.size() == rows * columns && b.size() == rows * right_sides);
  Sweep sweep{a, rows, columns, b, right_sides, {}};
  const double floor = rule.floor(std::max(rows, columns), largest_element(a));
  rule.complete ? sweep_complete(sweep, floor) : sweep_partial(sweep, floor);
  return std::move(sweep.echelon);
}

}  // namespace animado::egesp
