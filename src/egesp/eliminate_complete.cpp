// The downward sweep of Gauss–Jordan elimination with complete pivoting (echelon.hpp) on large matrices. The
// next pivot depends on every element, so nothing can be put off to a block: what is left is to look for it
// in the same pass that eliminates.
#include "egesp/blocked.hpp"
#include "egesp/tile.hpp"

namespace animado::egesp {
namespace {

template <class T>
void exchange(T& u, T& v) {
  const T kept = u;
  u = v;
  v = kept;
}

struct Pivot {
  size_t row, column;
  double size;
};

double largest_of(Lane lanes) {
  double largest = lanes[0];
  for (size_t x = 1; x < kWidth; ++x) largest = lanes[x] > largest ? lanes[x] : largest;
  return largest;
}

// The first element of a row from `column` on that is as large as `size`.
size_t find(const double* row, size_t column, double size) {
  while (absolute(row[column]) != size) ++column;
  return column;
}

void consider(Pivot& best, const double* row, size_t i, size_t column, double size) {
  if (size > best.size) best = {i, find(row, column, size), size};
}

// to ← to − factor · from; the largest element that comes out.
double subtract(double* to, double factor, const double* from, size_t count) {
  Lane largest = {};
  size_t j = 0;
  for (; j + kWidth <= count; j += kWidth) {
    const Lane difference = load(to + j) - factor * load(from + j);
    store(to + j, difference);
    const Lane size = absolute(difference);
    largest = size > largest ? size : largest;
  }
  double best = largest_of(largest);
  for (; j < count; ++j) {
    to[j] -= factor * from[j];
    best = absolute(to[j]) > best ? absolute(to[j]) : best;
  }
  return best;
}

Pivot first_pivot(const Reduction& of) {
  Pivot best{0, 0, 0};
  for (size_t i = 0; i < of.rows; ++i) {
    const double* row = of.a + i * of.columns;
    double largest = 0;
    for (size_t j = 0; j < of.columns; ++j) largest = absolute(row[j]) > largest ? absolute(row[j]) : largest;
    consider(best, row, i, 0, largest);
  }
  return best;
}

void exchange_rows(Reduction& of, size_t i, size_t k) {
  if (i == k) return;
  for (size_t j = 0; j < of.columns; ++j) exchange(of.a[i * of.columns + j], of.a[k * of.columns + j]);
  for (size_t j = 0; j < of.right_sides; ++j)
    exchange(of.b[i * of.right_sides + j], of.b[k * of.right_sides + j]);
  exchange(of.row_order[i], of.row_order[k]);
  of.odd = !of.odd;
}

void exchange_columns(Reduction& of, size_t j, size_t k) {
  if (j == k) return;
  for (size_t i = 0; i < of.rows; ++i) exchange(of.a[i * of.columns + j], of.a[i * of.columns + k]);
  exchange(of.column_order[j], of.column_order[k]);
  of.odd = !of.odd;
}

// Eliminates column k below the diagonal; the pivot that comes next.
Pivot eliminate_column(Reduction& of, size_t k) {
  const double* pivot = of.a + k * of.columns;
  const double inverse = 1.0 / pivot[k];
  Pivot next{k + 1, k + 1, 0};
  for (size_t i = k + 1; i < of.rows; ++i) {
    double* row = of.a + i * of.columns;
    const double factor = row[k] *= inverse;
    consider(next, row, i, k + 1, subtract(row + k + 1, factor, pivot + k + 1, of.columns - k - 1));
    subtract(of.b + i * of.right_sides, factor, of.b + k * of.right_sides, of.right_sides);
  }
  return next;
}

}  // namespace

void ANIMADO_INSTRUCTIONS::eliminate_complete(Reduction& of) {
  Pivot pivot = first_pivot(of);
  for (size_t k = 0; k < smaller(of.rows, of.columns); ++k) {
    if (!(pivot.size > of.floor)) return;
    exchange_rows(of, pivot.row, k);
    exchange_columns(of, pivot.column, k);
    pivot = eliminate_column(of, k);
    ++of.pivots;
  }
}

}  // namespace animado::egesp
