// The downward sweep of Gauss–Jordan elimination: A (rows × columns) to upper echelon form, B along with it.
//
//   k = 0, 1, …:  bring the pivot to a_kk by exchanging rows (partial) or rows and columns (complete);
//                 a_ij ← a_ij − (a_ik / a_kk) a_kj,   b_ij ← b_ij − (a_ik / a_kk) b_kj,   i > k
//
// The pivot is the largest remaining element in magnitude, the first of equals (row by row). Wilkinson, The
// Algebraic Eigenvalue Problem (1965), ch. 4; Higham, Accuracy and Stability of Numerical Algorithms (2002),
// ch. 9.
//
// Division is multiplication by the reciprocal of the pivot. Every element receives its terms in the order k
// = 0, 1, …, each rounded, however the loops are arranged: the plain ones here for small matrices, the
// blocked ones (blocked.hpp) for others, and the wide ones of lanes.cpp for many at a time all give the same
// bits.
#pragma once

#include <span>
#include <vector>

#include "egesp/instruction_set.hpp"
#include "egesp/pivot_rule.hpp"

namespace animado::egesp {

struct Echelon {
  size_t pivots = 0;         // accepted before one was refused: the rank when pivoting was complete
  bool odd = false;          // an odd number of exchanges: the determinant changes its sign
  std::vector<size_t> rows;  // row k of the form is this row of A
  std::vector<size_t>
      columns;  // complete pivoting: column k of the form is this column of A; empty for partial
};

// Row-major: a is rows × columns, b rows × right_sides (may be empty). Both are overwritten; below the
// diagonal a keeps the factors, so that L and U stand in it when every pivot was accepted.
Echelon reduce_to_echelon(std::span<double> a, size_t rows, size_t columns, std::span<double> b,
                          size_t right_sides, const PivotRule& rule,
                          InstructionSet instructions = widest_instruction_set());

}  // namespace animado::egesp
