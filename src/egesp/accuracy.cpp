#include "egesp/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace animado::egesp {
namespace {

constexpr int kMostSteps = 5;  // Higham's limit; two are the rule

constexpr double kRounding = 0x1p-52;  // a backward error up to this says nothing about the digits of x

double largest(std::span<const double> numbers, size_t first = 0, size_t stride = 1) {
  double size = 0;
  for (size_t i = first; i < numbers.size(); i += stride) size = std::max(size, std::abs(numbers[i]));
  return size;
}

double sum_of_sizes(std::span<const double> numbers) {
  double sum = 0;
  for (double v : numbers) sum += std::abs(v);
  return sum;
}

double backward_error_of(const Factored& a, double norm, std::span<const double> b, std::span<const double> x,
                         size_t m, size_t column, std::span<double> r) {
  a.residual(b, x, m, column, r);
  const double scale = norm * largest(x, column, m) + largest(b, column, m);
  return scale > 0 ? largest(r) / scale : 0.0;
}

// True when the signs of x are those of before already.
bool take_signs(std::span<const double> x, std::vector<double>& signs) {
  bool same = true;
  for (size_t i = 0; i < x.size(); ++i) {
    const double sign = x[i] < 0 ? -1 : 1;
    same = same && sign == signs[i];
    signs[i] = sign;
  }
  return same;
}

// ‖A⁻¹ (1, −(1 + 1/(n−1)), 1 + 2/(n−1), …)‖, for the matrices that mislead the ascent.
double estimate_by_alternation(const Factored& a) {
  const size_t n = a.size();
  std::vector<double> x(n);
  for (size_t i = 0; i < n; ++i)
    x[i] = (i % 2 == 0 ? 1 : -1) * (1 + static_cast<double>(i) / static_cast<double>(n - 1));
  a.solve(x, 1);
  return 2 * sum_of_sizes(x) / (3 * static_cast<double>(n));
}

// ‖A⁻¹‖₁ as the maximum of ‖A⁻¹ x‖₁ over ‖x‖₁ = 1: from a corner to a better one, along the gradient.
double norm_of_inverse(const Factored& a) {
  const size_t n = a.size();
  std::vector<double> x(n, 1.0 / static_cast<double>(n)), signs(n, 0.0);
  a.solve(x, 1);
  double norm = sum_of_sizes(x);
  if (n == 1) return norm;
  take_signs(x, signs);
  for (int step = 1; step < kMostSteps; ++step) {
    std::vector<double> gradient = signs;
    a.solve_transposed(gradient);
    const auto corner = std::ranges::max_element(gradient, {}, [](double v) { return std::abs(v); });
    std::ranges::fill(x, 0.0);
    x[static_cast<size_t>(corner - gradient.begin())] = 1;
    a.solve(x, 1);
    const double before = norm;
    norm = std::max(norm, sum_of_sizes(x));
    if (take_signs(x, signs) || norm <= before) break;
  }
  return std::max(norm, estimate_by_alternation(a));
}

}  // namespace

double backward_error(const Factored& a, std::span<const double> b, std::span<const double> x, size_t m) {
  const double norm = a.norm_rows();
  std::vector<double> r(a.size());
  double worst = 0;
  for (size_t c = 0; c < m; ++c) worst = std::max(worst, backward_error_of(a, norm, b, x, m, c, r));
  return worst;
}

void refine(const Factored& a, std::span<const double> b, std::span<double> x, size_t m) {
  const double norm = a.norm_rows();
  std::vector<double> r(a.size()), before(a.size());
  for (size_t c = 0; c < m; ++c) {
    const double error = backward_error_of(a, norm, b, x, m, c, r);
    a.solve(r, 1);
    for (size_t i = 0; i < r.size(); ++i) {
      before[i] = x[i * m + c];
      x[i * m + c] += r[i];
    }
    if (backward_error_of(a, norm, b, x, m, c, r) <= std::max(error, kRounding)) continue;
    for (size_t i = 0; i < r.size(); ++i) x[i * m + c] = before[i];
  }
}

double reciprocal_condition(const Factored& a) {
  const double inverse = norm_of_inverse(a);
  const double condition = a.norm_one() * inverse;
  return std::isfinite(condition) && condition > 0 ? 1 / condition : 0.0;
}

}  // namespace animado::egesp
