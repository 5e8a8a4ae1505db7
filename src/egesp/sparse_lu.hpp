// P R A Q = L U for a sparse matrix through SuiteSparse KLU: permutation to block triangular form, an
// ordering of each block that keeps the factors sparse, left-looking elimination (Gilbert and Peierls) with
// partial pivoting by threshold. Davis and Palamadai Natarajan, Algorithm 907: KLU, ACM Trans. Math. Softw.
// 37 (2010) 36.
//
// T, the threshold, is the preference for the diagonal: it is the pivot of its column when its size is at
// least T times the largest of the column. T = 1 is plain partial pivoting; a small T keeps the factors
// sparser.
#pragma once

#include <memory>

#include "egesp/factored.hpp"
#include "egesp/sparse_matrix.hpp"

namespace animado::egesp {

enum class Ordering { amd, colamd, natural };

struct SparseRule {
  double threshold = 0.001;  // T
  Ordering ordering = Ordering::amd;
};

class SparseLu final : public Factored {
 public:
  // Analyses and factors. Throws singular, which names a column, and limit when the factors would be too
  // large.
  SparseLu(SparseMatrix a, const SparseRule& rule);
  ~SparseLu() override;

  // Other values in the same places: the analysis and the order of pivots stay, unless these pivots turned
  // bad. Throws singular; solve then fails until other values come.
  void refactor(std::vector<double> values);

  struct Facts {
    int64_t entries;         // of A
    int64_t factor_entries;  // of L and U, both diagonals counted
    int64_t blocks;          // on the diagonal of the block triangular form
    double pivot_ratio;      // smallest |u_kk| over the largest: a first hint at the condition
  };
  Facts facts() const;
  size_t bytes() const;

  size_t size() const override { return static_cast<size_t>(a_.n); }
  double norm_one() const override;
  double norm_rows() const override;
  void solve(std::span<double> b, size_t m) const override;
  void solve_transposed(std::span<double> b) const override;
  void residual(std::span<const double> b, std::span<const double> x, size_t m, size_t column,
                std::span<double> r) const override;

 private:
  void factor();

  SparseMatrix a_;
  struct Klu;
  std::unique_ptr<Klu> klu_;
};

}  // namespace animado::egesp
