#include "egesp/dense_system.hpp"

#include <cmath>

namespace animado::egesp {

double DenseSystem::norm_one() const {
  const size_t n = size();
  std::vector<double> sums(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) sums[j] += std::abs(a_[i * n + j]);
  }
  return *std::ranges::max_element(sums);
}

double DenseSystem::norm_rows() const {
  const size_t n = size();
  double largest = 0;
  for (size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (double v : a_.subspan(i * n, n)) sum += std::abs(v);
    largest = std::max(largest, sum);
  }
  return largest;
}

void DenseSystem::residual(std::span<const double> b, std::span<const double> x, size_t m, size_t column,
                           std::span<double> r) const {
  const size_t n = size();
  for (size_t i = 0; i < n; ++i) {
    long double sum = b[i * m + column];
    for (size_t j = 0; j < n; ++j) sum -= static_cast<long double>(a_[i * n + j]) * x[j * m + column];
    r[i] = static_cast<double>(sum);
  }
}

}  // namespace animado::egesp
