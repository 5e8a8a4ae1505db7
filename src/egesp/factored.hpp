// A matrix beside its factors, dense or sparse: what the questions of accuracy.hpp are asked of.
#pragma once

#include <cstddef>
#include <span>

namespace animado::egesp {

class Factored {
 public:
  virtual ~Factored() = default;

  virtual size_t size() const = 0;       // n
  virtual double norm_one() const = 0;   // max over columns of Σ |a_ij|
  virtual double norm_rows() const = 0;  // max over rows: the norm that belongs to the largest component

  // b: (n, m), row-major, becomes X of A X = B.
  virtual void solve(std::span<double> b, size_t m) const = 0;
  virtual void solve_transposed(std::span<double> b) const = 0;  // Aᵀ x = b

  // r ← b − A x, summed with 64 bits of fraction and rounded once. b and x are column `column` of (n, m).
  virtual void residual(std::span<const double> b, std::span<const double> x, size_t m, size_t column,
                        std::span<double> r) const = 0;
};

}  // namespace animado::egesp
