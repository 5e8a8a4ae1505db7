// A X = B for one system of any size by Gauss–Jordan elimination: the downward sweep of echelon.hpp, then the
// upward one,
//
//   k = n−1 … 0:  x_k ← b_k / a_kk;   b_i ← b_i − a_ik x_k,   i < k
//
// Deviation from the textbook, which clears each column above and below its pivot at once: clearing above in
// a second sweep takes two thirds of the work and is backward stable where the one sweep is not (Higham 2002,
// section 14.4).
#pragma once

#include "egesp/echelon.hpp"

namespace animado::egesp {

struct Elimination {
  size_t pivots = 0;       // accepted; when fewer than n, the pivot of this index was refused
  bool finite = false;     // all pivots were accepted and X did not overflow
  double determinant = 0;  // 0 when a pivot was refused

  bool solved() const { return finite; }
};

// Row-major: a (n, n) is used up, b (n, m) becomes X. What is in b is of no use unless solved().
Elimination gauss_jordan(std::span<double> a, std::span<double> b, size_t n, size_t m, const PivotRule& rule,
                         InstructionSet instructions = widest_instruction_set());

}  // namespace animado::egesp
