// The downward sweep of Gauss–Jordan elimination with partial pivoting (echelon.hpp) on large matrices, a
// panel of columns at a time: the panel is eliminated by itself, then the rest of the matrix and the
// right-hand sides receive the terms of all its columns, a tile at a time. Right-looking, as in LAPACK's
// dgetrf (Anderson et al., LAPACK Users' Guide, 1999); every element receives its terms in the order k = 0,
// 1, …, so that the bits are those of the plain loops.
//
// A panel is kept in groups of kRows rows, each group column by column: one column of a group fills a
// register, and the group as it lies is the S of a tile.
#include "egesp/blocked.hpp"
#include "egesp/tile.hpp"

namespace animado::egesp {
namespace {

constexpr size_t kSub = 8;                     // columns of a panel that are eliminated one by one
constexpr size_t kRegisters = kRows / kWidth;  // of one column of a group

struct Panel {
  Reduction& reduction;
  size_t first, depth;  // its columns of A; rows of A from the same on
  size_t height;        // rows
  double* numbers;      // groups; rows and columns that A does not have are zeros
  double* strip;        // rows of pivots of one strip of the rest

  double* group(size_t g) const { return numbers + g * kGroup; }
  double& at(size_t row, size_t column) const {
    return numbers[row / kRows * kGroup + column * kRows + row % kRows];
  }
};

void exchange(double* u, double* v, size_t count) {
  for (size_t j = 0; j < count; ++j) {
    const double kept = u[j];
    u[j] = v[j];
    v[j] = kept;
  }
}

void read_panel(const Panel& p) {
  const Reduction& of = p.reduction;
  for (size_t i = 0; i < p.height; i += kRows) {
    double* group = p.group(i / kRows);
    const size_t rows = smaller(kRows, p.height - i);
    if (rows < kRows || p.depth < kPanel) {
      for (size_t e = 0; e < kGroup; ++e) group[e] = 0;
    }
    for (size_t r = 0; r < rows; ++r) {
      const double* row = of.a + (p.first + i + r) * of.columns + p.first;
      for (size_t k = 0; k < p.depth; ++k) group[k * kRows + r] = row[k];
    }
  }
}

void write_panel(const Panel& p) {
  const Reduction& of = p.reduction;
  for (size_t i = 0; i < p.height; ++i) {
    const double* from = &p.at(i, 0);
    double* row = of.a + (p.first + i) * of.columns + p.first;
    for (size_t k = 0; k < p.depth; ++k) row[k] = from[k * kRows];
  }
}

// The columns from `column` on, kSub of them, receive the terms of the columns before them.
void catch_up(const Panel& p, size_t column) {
  for (size_t i = 0; i < p.height; i += kRows) {
    double* group = p.group(i / kRows);
    double* to = group + column * kRows;
    Lane sum[kSub][kRegisters];
    ANIMADO_UNROLL for (size_t j = 0; j < kSub; ++j) {
      ANIMADO_UNROLL for (size_t x = 0; x < kRegisters; ++x) sum[j][x] = load(to + j * kRows + x * kWidth);
    }
    for (size_t k = 0; k < smaller(i, column); ++k) {
      const double* pivots = &p.at(k, column);
      ANIMADO_UNROLL for (size_t j = 0; j < kSub; ++j) {
        ANIMADO_UNROLL for (size_t x = 0; x < kRegisters; ++x) {
          sum[j][x] -= pivots[j * kRows] * load(group + k * kRows + x * kWidth);
        }
      }
    }
    ANIMADO_UNROLL for (size_t j = 0; j < kSub; ++j) {
      ANIMADO_UNROLL for (size_t x = 0; x < kRegisters; ++x) store(to + j * kRows + x * kWidth, sum[j][x]);
    }
    for (size_t k = 0; i < column && k < kRows; ++k) {
      for (size_t j = 0; j < kSub; ++j) {
        for (size_t r = k + 1; r < kRows; ++r)
          to[j * kRows + r] -= group[(i + k) * kRows + r] * to[j * kRows + k];
      }
    }
  }
}

// The first row with the largest element of a column, at or below the diagonal.
size_t pivot_row(const Panel& p, size_t column) {
  const size_t next = (column / kRows + 1) * kRows;
  size_t best_row = column;
  for (size_t i = column + 1; i < smaller(next, p.height); ++i) {
    if (absolute(p.at(i, column)) > absolute(p.at(best_row, column))) best_row = i;
  }
  double best = absolute(p.at(best_row, column));
  Lane largest[kRegisters] = {};
  Mask where[kRegisters] = {};
  for (size_t i = next; i < p.height; i += kRows) {
    ANIMADO_UNROLL for (size_t x = 0; x < kRegisters; ++x) {
      const Lane size = absolute(load(&p.at(i, column) + x * kWidth));
      const Mask is_larger = size > largest[x];
      largest[x] = is_larger ? size : largest[x];
      where[x] = is_larger ? Mask{} + static_cast<long long>(i) : where[x];
    }
  }
  bool below = false;
  for (size_t r = 0; r < kRows; ++r) {
    const double size = largest[r / kWidth][r % kWidth];
    const size_t row = static_cast<size_t>(where[r / kWidth][r % kWidth]) + r;
    if (size > best || (below && size == best && row < best_row)) best = size, best_row = row, below = true;
  }
  return best_row;
}

void exchange_rows(const Panel& p, size_t i, size_t k) {
  Reduction& of = p.reduction;
  if (i == k) return;
  for (size_t j = 0; j < p.depth; ++j) exchange(&p.at(i, j), &p.at(k, j), 1);
  const size_t u = p.first + i, v = p.first + k, last = p.first + p.depth;
  exchange(of.a + u * of.columns, of.a + v * of.columns, p.first);
  exchange(of.a + u * of.columns + last, of.a + v * of.columns + last, of.columns - last);
  exchange(of.b + u * of.right_sides, of.b + v * of.right_sides, of.right_sides);
  const size_t kept = of.row_order[u];
  of.row_order[u] = of.row_order[v];
  of.row_order[v] = kept;
  of.odd = !of.odd;
}

// Stores the factors of a column and applies them to the panel's columns up to `end`.
void eliminate_column(const Panel& p, size_t column, size_t end) {
  const double inverse = 1.0 / p.at(column, column);
  const size_t next = (column / kRows + 1) * kRows;
  double pivots[kSub];
  for (size_t j = column + 1; j < end; ++j) pivots[j - column - 1] = p.at(column, j);
  for (size_t i = column + 1; i < smaller(next, p.height); ++i) {
    const double factor = p.at(i, column) *= inverse;
    for (size_t j = column + 1; j < end; ++j) p.at(i, j) -= factor * pivots[j - column - 1];
  }
  for (size_t i = next; i < p.height; i += kRows) {
    double* to = p.group(i / kRows) + column * kRows;
    ANIMADO_UNROLL for (size_t x = 0; x < kRegisters; ++x, to += kWidth) {
      const Lane factor = load(to) * inverse;
      store(to, factor);
      for (size_t j = 1; j < end - column; ++j)
        store(to + j * kRows, load(to + j * kRows) - factor * pivots[j - 1]);
    }
  }
}

// False when a pivot was refused.
bool eliminate_panel(const Panel& p) {
  for (size_t sub = 0; sub < p.depth; sub += kSub) {
    if (sub > 0) catch_up(p, sub);
    const size_t end = smaller(sub + kSub, p.depth);
    for (size_t k = sub; k < end; ++k) {
      const size_t i = pivot_row(p, k);
      if (!(absolute(p.at(i, k)) > p.reduction.floor)) return false;
      exchange_rows(p, i, k);
      eliminate_column(p, k, end);
      ++p.reduction.pivots;
    }
  }
  return true;
}

// Applies the panel to columns beside it, of which c is the panel's first row.
template <size_t Vectors>
void update_strip(const Panel& p, double* c, size_t c_stride, size_t columns) {
  constexpr size_t kColumns = Vectors * kWidth;
  const size_t solved = smaller((p.depth + kRows - 1) / kRows * kRows, p.height);
  for (size_t i = 0; i < (solved + kRows - 1) / kRows * kRows; ++i) {
    for (size_t x = 0; x < kColumns; ++x)
      p.strip[i * kColumns + x] = i < solved && x < columns ? c[i * c_stride + x] : 0;
  }
  for (size_t i = 0; i < p.depth; i += kRows) {
    double* rows = p.strip + i * kColumns;
    const double* group = p.group(i / kRows);
    subtract_tile<Vectors>(rows, kColumns, group, p.strip, i);
    for (size_t k = 0; k < smaller(kRows, p.depth - i); ++k) {
      for (size_t r = k + 1; r < kRows; ++r) {
        const double factor = group[(i + k) * kRows + r];
        for (size_t x = 0; x < kColumns; x += kWidth)
          store(rows + r * kColumns + x,
                load(rows + r * kColumns + x) - factor * load(rows + k * kColumns + x));
      }
    }
  }
  for (size_t i = 0; i < solved; ++i) {
    for (size_t x = 0; x < columns; ++x) c[i * c_stride + x] = p.strip[i * kColumns + x];
  }
  if (solved < p.height)
    subtract_groups<Vectors>(c + solved * c_stride, c_stride, p.height - solved, columns,
                             p.group(solved / kRows), p.strip, p.depth);
}

void update(const Panel& p, double* c, size_t c_stride, size_t columns) {
  for_each_strip(columns, [&]<size_t Vectors>(size_t first, size_t width) {
    update_strip<Vectors>(p, c + first, c_stride, width);
  });
}

}  // namespace

void ANIMADO_INSTRUCTIONS::eliminate(Reduction& of) {
  const size_t steps = smaller(of.rows, of.columns);
  double* numbers = of.scratch + 2048;
  for (size_t first = 0; first < steps; first += kPanel) {
    const Panel panel{of, first, smaller(kPanel, steps - first), of.rows - first, numbers, of.scratch};
    const size_t last = first + panel.depth;
    read_panel(panel);
    if (!eliminate_panel(panel)) return;
    write_panel(panel);
    update(panel, of.a + first * of.columns + last, of.columns, of.columns - last);
    update(panel, of.b + first * of.right_sides, of.right_sides, of.right_sides);
  }
}

}  // namespace animado::egesp
