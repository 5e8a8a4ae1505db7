// Substitution with the triangles of a reduced matrix, a block of unknowns at a time,
//
//   upward:    k = n−1 … 0:  x_k ← b_k / u_kk;   b_i ← b_i − u_ik x_k,   i < k
//   downward:  k = 0 … n−1:  x_k ← b_k;          b_i ← b_i − l_ik x_k,   i > k
//
// Each b_i receives its terms in the order of k, so the bits are those of the plain loops. Division is
// multiplication by the reciprocal, as in echelon.hpp.
#include "egesp/blocked.hpp"
#include "egesp/tile.hpp"

namespace animado::egesp {
namespace {

// Rows `begin` … `end` − 1 receive the terms of `depth` unknowns: those of the columns first, first + step, …
struct Terms {
  size_t begin, end, first, depth;
  ptrdiff_t step;
};

void subtract_row(double* to, double factor, const double* from, size_t count) {
  size_t j = 0;
  for (; j + kWidth <= count; j += kWidth) store(to + j, load(to + j) - factor * load(from + j));
  for (; j < count; ++j) to[j] -= factor * from[j];
}

void pack_factors(const Substitution& s, const Terms& terms, double* groups) {
  for (size_t i = terms.begin; i < terms.end; i += kRows, groups += kGroup) {
    for (size_t r = 0; r < kRows; ++r) {
      const double* from = s.a + (i + r) * s.n + terms.first;
      for (size_t k = 0; k < terms.depth; ++k)
        groups[k * kRows + r] = i + r < terms.end ? from[static_cast<ptrdiff_t>(k) * terms.step] : 0;
    }
  }
}

template <size_t Vectors>
void subtract_strip(const Substitution& s, const Terms& terms, const double* groups, double* strip,
                    size_t column, size_t columns) {
  constexpr size_t kColumns = Vectors * kWidth;
  const double* from = s.b + terms.first * s.m + column;
  for (size_t k = 0; k < terms.depth; ++k) {
    const double* row = from + static_cast<ptrdiff_t>(k) * terms.step * static_cast<ptrdiff_t>(s.m);
    for (size_t x = 0; x < kColumns; ++x) strip[k * kColumns + x] = x < columns ? row[x] : 0;
  }
  subtract_groups<Vectors>(s.b + terms.begin * s.m + column, s.m, terms.end - terms.begin, columns, groups,
                           strip, terms.depth);
}

void subtract(const Substitution& s, const Terms& terms) {
  if (terms.begin == terms.end) return;
  double* groups = s.scratch + 2048;
  pack_factors(s, terms, groups);
  for_each_strip(s.m, [&]<size_t Vectors>(size_t column, size_t columns) {
    subtract_strip<Vectors>(s, terms, groups, s.scratch, column, columns);
  });
}

}  // namespace

void ANIMADO_INSTRUCTIONS::substitute_upward(const Substitution& s) {
  for (size_t last = s.n; last > 0;) {
    const size_t first = last - smaller(kPanel, last);
    for (size_t k = last; k-- > first;) {
      double* x = s.b + k * s.m;
      const double inverse = 1.0 / s.a[k * s.n + k];
      for (size_t c = 0; c < s.m; ++c) x[c] *= inverse;
      for (size_t i = first; i < k; ++i) subtract_row(s.b + i * s.m, s.a[i * s.n + k], x, s.m);
    }
    subtract(s, {0, first, last - 1, last - first, -1});
    last = first;
  }
}

void ANIMADO_INSTRUCTIONS::substitute_downward(const Substitution& s) {
  for (size_t first = 0; first < s.n;) {
    const size_t last = first + smaller(kPanel, s.n - first);
    for (size_t k = first; k < last; ++k) {
      for (size_t i = k + 1; i < last; ++i) subtract_row(s.b + i * s.m, s.a[i * s.n + k], s.b + k * s.m, s.m);
    }
    subtract(s, {last, s.n, first, last - first, 1});
    first = last;
  }
}

}  // namespace animado::egesp
