// The sums of a Runge–Kutta step, several elements of the state at once. Plain types only, because lanes.cpp
// is compiled once for each instruction set and may share no inline function with the rest of the program.
#pragma once

#include <stddef.h>

namespace animado::fred {

inline constexpr size_t kLaneGroup = 4;  // numbers come in multiples of it, at addresses of 32 bytes
inline constexpr int kMostTerms = 16;    // of a sum

// Σ_j coefficients[j] k[rows[j]], taken in the order of j, each operation rounded.
struct Sum {
  int count = 0;  // at least 1
  unsigned char rows[kMostTerms] = {};
  double coefficients[kMostTerms] = {};
};

// absolute + relative max(|y_i|, |end_i|); `stride` is 0 for one tolerance of all elements, 1 for one of
// each.
struct ErrorScale {
  const double *absolute, *relative;
  size_t stride;
};

// One kernel for each number of terms, so that the loop over them is unrolled; [0] is not used.
struct LaneKernels {
  // out = y + h sum. `out` is apart from what is read.
  void (*combine[kMostTerms + 1])(const double* y, const double* const* k, const Sum& sum, double h,
                                  double* out, size_t size);
  // Σ_i (sum_i / scale_i)², in the order of four running sums, whatever the width of a register. Elements
  // beyond those in use have derivatives 0.
  double (*square_error[kMostTerms + 1])(const double* y, const double* end, const double* const* k,
                                         const Sum& sum, const ErrorScale& scale, size_t size);
};

extern const LaneKernels kLanesSse2, kLanesAvx2;

}  // namespace animado::fred
