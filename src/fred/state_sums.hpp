// The sums of a Runge–Kutta step over states of one size, by the kernels that suit it: their bits do not
// depend on which.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fred/control.hpp"
#include "fred/lanes.hpp"

namespace animado::fred {

// Terms whose coefficient is zero are left out: their derivatives are not read. At most kMostTerms are left.
Sum sum_of(std::span<const double> coefficients);

using SquareErrors = std::array<double, kMostEstimates>;

// Where each of the derivatives begins that lie one after the other, `size` numbers each.
std::vector<const double*> rows_of(std::span<const double> derivatives, size_t size);

class StateSums {
 public:
  explicit StateSums(size_t size);

  // out = y + h Σ; see LaneKernels::combine.
  void combine(const double* y, const double* const* k, const Sum& sum, double h, double* out) const {
    if (wide_size_ > 0) wide_.combine[sum.count](y, k, sum, h, out, 0, wide_size_);
    if (wide_size_ < size_) kLanesOne.combine[sum.count](y, k, sum, h, out, wide_size_, size_);
  }

  // Of each estimate, Σ_i (sum_i / scale_i)². All of them read the same derivatives.
  SquareErrors square_errors(const double* y, const double* end, const double* const* k,
                             std::span<const Sum> estimates, const Tolerance& tolerance) const;

  bool are_finite(const double* v) const;

 private:
  const LaneKernels &wide_, &errors_;  // those that estimate errors
  size_t size_;
  size_t wide_size_, errors_size_;  // the elements beyond go one by one
};

// For states in rows of which each begins at an address of 64 bytes, with zeros behind it up to the next: no
// element is left over.
struct WholeLanes {
  explicit WholeLanes(size_t size);

  const LaneKernels& kernels;
  size_t end;  // of what they work on
};

}  // namespace animado::fred
