// P A Q = L U for one matrix of any size, and what can be solved with the factors again and again. The
// factors are those of gauss_jordan.hpp, which sweeps its right-hand sides along instead of keeping them for
// later: the solutions have the same bits.
//
// P: exchanges of rows; Q: exchanges of columns (complete pivoting). The elimination itself is echelon.hpp.
#pragma once

#include "egesp/echelon.hpp"

namespace animado::egesp {

class Lu {
 public:
  // a: (n, n), row-major; the factors take its place.
  Lu(std::vector<double> a, size_t n, const PivotRule& rule,
     InstructionSet instructions = widest_instruction_set());

  size_t size() const { return n_; }
  size_t pivots() const { return echelon_.pivots; }  // accepted; when fewer than n, this one was refused
  bool factored() const { return echelon_.pivots == n_; }
  double determinant() const;     // 0 when a pivot was refused
  double largest_factor() const;  // max |u_ij|: over max |a_ij|, the growth factor
  size_t bytes() const;

  // b: (n, m), row-major, becomes X of A X = B. Only when factored().
  void solve(std::span<double> b, size_t m) const;
  void solve_transposed(std::span<double> b) const;  // Aᵀ x = b

 private:
  size_t n_;
  InstructionSet instructions_;
  std::vector<double> factors_;
  Echelon echelon_;
};

}  // namespace animado::egesp
