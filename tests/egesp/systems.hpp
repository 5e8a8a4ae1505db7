// Linear systems to test with, and how well a solution fits.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "egesp/sparse_matrix.hpp"

namespace animado::egesp {

inline constexpr double kUnit = 0x1p-53;  // the relative error of one rounding

// In the order of InstructionSet.
inline constexpr const char* kInstructionSetNames[] = {"scalar", "sse2", "avx2", "avx512"};

// The generator of the benchmark scenes: a 64-bit linear congruential one, the same on every machine.
class Uniform {
 public:
  double operator()(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 33) / 2147483648.0;
  }

 private:
  uint64_t state_ = 12345;
};

inline std::vector<double> random_numbers(Uniform& uniform, size_t count) {
  std::vector<double> numbers(count);
  for (double& v : numbers) v = uniform(-1, 1);
  return numbers;
}

inline std::vector<uint64_t> bits(const std::vector<double>& numbers) {
  std::vector<uint64_t> raw;
  for (double v : numbers) raw.push_back(std::bit_cast<uint64_t>(v));
  return raw;
}

inline std::vector<double> hilbert(size_t n) {
  std::vector<double> a(n * n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) a[i * n + j] = 1.0 / static_cast<double>(i + j + 1);
  }
  return a;
}

// −Δ on a square of k × k points, five elements a row.
inline SparseMatrix poisson(int k) {
  std::vector<double> rows, columns, values;
  const auto add = [&](int i, int j, double value) {
    rows.push_back(i), columns.push_back(j), values.push_back(value);
  };
  for (int i = 0; i < k * k; ++i) {
    add(i, i, 4);
    if (i % k > 0) add(i, i - 1, -1);
    if (i % k < k - 1) add(i, i + 1, -1);
    if (i >= k) add(i, i - k, -1);
    if (i < k * (k - 1)) add(i, i + k, -1);
  }
  return SparsePattern(SparseFormat::triplets, k * k, rows, columns, values.size()).matrix(values);
}

// The smallest relative change of A and b that makes x exact, ‖b − A x‖ / (‖A‖ ‖x‖ + ‖b‖) in the maximum norm
// (Rigal and Gaches 1967), the largest over the right-hand sides. All row-major.
inline double backward_error(const double* a, const double* b, const double* x, size_t n, size_t m) {
  double worst = 0;
  for (size_t c = 0; c < m; ++c) {
    long double residual = 0, norm_a = 0, norm_x = 0, norm_b = 0;
    for (size_t i = 0; i < n; ++i) {
      long double r = b[i * m + c], row = 0;
      for (size_t j = 0; j < n; ++j) {
        r -= static_cast<long double>(a[i * n + j]) * x[j * m + c];
        row += std::abs(a[i * n + j]);
      }
      residual = std::max(residual, std::abs(r));
      norm_a = std::max(norm_a, row);
      norm_x = std::max(norm_x, std::abs(static_cast<long double>(x[i * m + c])));
      norm_b = std::max(norm_b, std::abs(static_cast<long double>(b[i * m + c])));
    }
    worst = std::max(worst, static_cast<double>(residual / (norm_a * norm_x + norm_b)));
  }
  return worst;
}

}  // namespace animado::egesp
