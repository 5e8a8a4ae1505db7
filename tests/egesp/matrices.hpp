// Matrices with a reputation, each with what is proved of it. Sources: Higham, Accuracy and Stability of
// Numerical Algorithms (2002), chapters 9 and 28; Wilkinson, The Algebraic Eigenvalue Problem (1965), chapter
// 4; Golub and Van Loan (2013).
#pragma once

#include <functional>

#include "systems.hpp"

namespace animado::egesp {

using Numbers = std::vector<double>;

inline Numbers filled(size_t n, const std::function<double(double i, double j)>& element) {
  Numbers a(n * n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) a[i * n + j] = element(static_cast<double>(i), static_cast<double>(j));
  }
  return a;
}

// Under partial pivoting the last column doubles at each step, and U ends in 2ⁿ⁻¹: the bound is reached.
inline Numbers wilkinson(size_t n) {
  return filled(n, [n](double i, double j) {
    return i == j || j == static_cast<double>(n - 1) ? 1.0 : i > j ? -1.0 : 0.0;
  });
}

// Triangular, with columns of one norm: pivoting by columns never moves one, and the last diagonal element
// hides how near the matrix is to a singular one. s = sin 1.2, c = cos 1.2.
inline Numbers kahan(size_t n) {
  return filled(n, [](double i, double j) {
    return std::pow(std::sin(1.2), i) * (i == j ? 1.0 : i < j ? -std::cos(1.2) : 0.0);
  });
}

// Points 0, 1/n, 2/n, …: row i holds the powers of point i.
inline double vandermonde_point(size_t n, size_t i) {
  return static_cast<double>(i) / static_cast<double>(n);
}
inline Numbers vandermonde(size_t n) {
  return filled(
      n, [n](double i, double j) { return std::pow(vandermonde_point(n, static_cast<size_t>(i)), j); });
}

// Binomials: the determinant is 1, the inverse is of integers.
inline Numbers pascal(size_t n) {
  Numbers a = filled(n, [](double, double) { return 1.0; });
  for (size_t i = 1; i < n; ++i) {
    for (size_t j = 1; j < n; ++j) a[i * n + j] = a[(i - 1) * n + j] + a[i * n + j - 1];
  }
  return a;
}

// Upper Hessenberg with determinant 1 and eigenvalues that are hard to find.
inline Numbers frank(size_t n) {
  return filled(
      n, [n](double i, double j) { return j + 1 < i ? 0.0 : static_cast<double>(n) - std::max(i, j); });
}

// Toeplitz, r^|i − j|: the determinant is (1 − r²)ⁿ⁻¹, the inverse tridiagonal (Kac, Murdock and Szegő).
inline Numbers toeplitz(size_t n) {
  return filled(n, [](double i, double j) { return std::pow(0.5, std::abs(i - j)); });
}

// −1, 2, −1: the determinant is n + 1, the inverse min(i, j) − i j / (n + 1), counted from 1.
inline Numbers second_difference(size_t n) {
  return filled(n, [](double i, double j) { return i == j ? 2.0 : std::abs(i - j) == 1 ? -1.0 : 0.0; });
}

inline Numbers random_matrix(size_t n) {
  Uniform uniform;
  return random_numbers(uniform, n * n);
}

inline Numbers diagonally_dominant(size_t n) {
  Numbers a = random_matrix(n);
  for (size_t i = 0; i < n; ++i) a[i * n + i] = static_cast<double>(n);
  return a;
}

// Rows that shrink by a factor of 10 each, over up to 60 orders of magnitude.
inline Numbers graded(size_t n) {
  Numbers a = diagonally_dominant(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) a[i * n + j] *= std::pow(10.0, -static_cast<double>(i % 60));
  }
  return a;
}

}  // namespace animado::egesp
