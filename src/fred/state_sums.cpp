#include "fred/state_sums.hpp"

#include <cassert>

namespace animado::fred {
namespace {

// The stages of a small state go one element after the other: the derivative has just written it so, and a
// wide load of what is still on its way to the cache waits for it. Its error, for which most derivatives are
// older, does not.
constexpr size_t kSmall = 16;

// From here on the widest registers are worth what is left over of them.
constexpr size_t kLarge = 256;

const LaneKernels& error_kernels() {
  return __builtin_cpu_supports("avx2") ? kLanesAvx2 : kLanesSse2;
}

const LaneKernels& wide_kernels(size_t size) {
  return size >= kLarge && __builtin_cpu_supports("avx512f") ? kLanesAvx512 : error_kernels();
}

size_t whole_lanes(size_t size, const LaneKernels& kernels) {
  return size <= kSmall ? 0 : size / kernels.width * kernels.width;
}

}  // namespace

Sum sum_of(std::span<const double> coefficients) {
  Sum sum;
  for (size_t j = 0; j < coefficients.size(); ++j) {
    if (coefficients[j] == 0) continue;
    assert(sum.count < kMostTerms);
    sum.rows[sum.count] = static_cast<unsigned char>(j);
    sum.coefficients[sum.count++] = coefficients[j];
  }
  if (sum.count == 0) sum.count = 1;  // 0 k_0
  return sum;
}

std::vector<const double*> rows_of(std::span<const double> derivatives, size_t size) {
  std::vector<const double*> rows(size == 0 ? 0 : derivatives.size() / size);
  for (size_t j = 0; j < rows.size(); ++j) rows[j] = derivatives.data() + j * size;
  return rows;
}

StateSums::StateSums(size_t size)
    : wide_(wide_kernels(size)),
      errors_(error_kernels()),
      size_(size),
      wide_size_(whole_lanes(size, wide_)),
      errors_size_(size / errors_.width * errors_.width) {}

SquareErrors StateSums::square_errors(const double* y, const double* end, const double* const* k,
                                      std::span<const Sum> estimates, const Tolerance& tolerance) const {
  const ErrorScale scale = {tolerance.absolute.data(), tolerance.relative.data(), tolerance.stride()};
  const size_t kind = estimates.size(), terms = static_cast<size_t>(estimates[0].count);
  double running[kMostEstimates][kRunningSums] = {};
  const auto add = [&](const LaneKernels& kernels, size_t from, size_t to) {
    kernels.square_errors[kind][terms](y, end, k, estimates.data(), scale, running, from, to);
  };
  if (errors_size_ > 0) add(errors_, 0, errors_size_);
  if (errors_size_ < size_) add(kLanesOne, errors_size_, size_);
  SquareErrors squares = {};
  for (size_t i = 0; i < kind; ++i) {
    squares[i] = (running[i][0] + running[i][1]) + (running[i][2] + running[i][3]);
  }
  return squares;
}

bool StateSums::are_finite(const double* v) const {
  return wide_.are_finite(v, 0, wide_size_) && kLanesOne.are_finite(v, wide_size_, size_);
}

WholeLanes::WholeLanes(size_t size)
    : kernels(size <= kSmall ? kLanesOne : wide_kernels(size)),
      end((size + kernels.width - 1) / kernels.width * kernels.width) {}

}  // namespace animado::fred
