// min ‖b − A x‖₂ for a matrix of any shape and rank, by Householder reflections with column pivoting,
//
//   Q A P = [R₁₁ R₁₂; 0 0],  R₁₁ upper triangular of size rank,
//
// and for the solution of minimum norm the complete orthogonal decomposition, [R₁₁ R₁₂] Z = [T 0]. Businger
// and Golub, Numer. Math. 7 (1965) 269; Golub and Van Loan, Matrix Computations (2013), sections 5.4.2, 5.4.7
// and 5.5; the norms of the columns are brought up to date as in Drmač and Bujanović, ACM Trans. Math. Softw.
// 35 (2008) 12.
//
// The rank is the number of diagonal elements of R larger than T times the first. As every method by columns
// it may see a rank that is too large in matrices made for it (Kahan's).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace animado::egesp {

struct LeastSquaresProblem {
  std::span<const double> a, b;  // (rows, columns) and (rows, m), row-major
  size_t rows, columns, m;
  double threshold = 0;       // T; 0 means max(rows, columns) · 2⁻⁵²
  bool minimum_norm = false;  // of all solutions; else one with at most `rank` components that are not zero
};

struct LeastSquaresSolution {
  size_t rank = 0;
  std::vector<double> x;               // (columns, m), row-major
  std::vector<double> residual_norms;  // ‖b − A x‖₂ of each right-hand side
};

// All numbers must be finite.
LeastSquaresSolution least_squares(const LeastSquaresProblem& problem);

}  // namespace animado::egesp
