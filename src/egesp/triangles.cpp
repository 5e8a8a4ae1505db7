#include "egesp/triangles.hpp"

#include <cassert>

#include "egesp/blocked_kernels.hpp"

namespace animado::egesp {
namespace {

bool is_plain(size_t n, InstructionSet instructions) {
  return n <= kPlain || instructions == InstructionSet::scalar;
}

// b_i ← b_i − factor · b_k
void subtract(std::span<double> b, size_t m, size_t i, double factor, size_t k) {
  for (size_t c = 0; c < m; ++c) b[i * m + c] -= factor * b[k * m + c];
}

}  // namespace

void substitute_downward(std::span<const double> reduced, size_t n, std::span<double> b, size_t m,
                         InstructionSet instructions) {
  assert(reduced.size() == n * n && b.size() == n * m);
  if (!is_plain(n, instructions)) {
    AlignedNumbers scratch(scratch_numbers(n));
    blocked_kernels(instructions).substitute_downward({reduced.data(), n, b.data(), m, scratch.data()});
    return;
  }
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < i; ++k) subtract(b, m, i, reduced[i * n + k], k);
  }
}

void substitute_upward(std::span<const double> reduced, size_t n, std::span<double> b, size_t m,
                       InstructionSet instructions) {
  assert(reduced.size() == n * n && b.size() == n * m);
  if (!is_plain(n, instructions)) {
    AlignedNumbers scratch(scratch_numbers(n));
    blocked_kernels(instructions).substitute_upward({reduced.data(), n, b.data(), m, scratch.data()});
    return;
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = n; k-- > i + 1;) subtract(b, m, i, reduced[i * n + k], k);
    const double inverse = 1.0 / reduced[i * n + i];
    for (size_t c = 0; c < m; ++c) b[i * m + c] *= inverse;
  }
}

void substitute_transposed_downward(std::span<const double> reduced, size_t n, std::span<double> b) {
  for (size_t k = 0; k < n; ++k) {
    const double* row = reduced.data() + k * n;
    const double x = b[k] *= 1.0 / row[k];
    for (size_t i = k + 1; i < n; ++i) b[i] -= row[i] * x;
  }
}

void substitute_transposed_upward(std::span<const double> reduced, size_t n, std::span<double> b) {
  for (size_t k = n; k-- > 0;) {
    const double* row = reduced.data() + k * n;
    for (size_t i = 0; i < k; ++i) b[i] -= row[i] * b[k];
  }
}

}  // namespace animado::egesp
