// The sums of a Runge–Kutta step, several elements of the state at once. Plain types only, because lanes.cpp
// is compiled once for each instruction set and may share no inline function with the rest of the program.
// Choose the kernels through StateSums.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace animado::fred {

inline constexpr int kMostTerms = 16;           // of a sum
inline constexpr size_t kMostDerivatives = 24;  // of a method
inline constexpr int kMostEstimates = 2;        // of the error of one step
inline constexpr size_t kRunningSums = 4;

// Σ_j coefficients[j] k[rows[j]], taken in the order of j, each operation rounded. A step makes h Σ_j of it,
// or Σ_j (h coefficients[j]) k[rows[j]] where it takes the step.
//
// The latter is for stages, where it spares a multiplication. The rounding of h a_j is the same in every step
// of one length, and adds up: beside 128-bit numbers it made the error of the end's sum up to 22 times as
// large (verner87), and that of a stage of large coefficients 9 times. Where they are small the step's own
// rounding hides it.
struct Sum {
  int count = 0;  // at least 1
  bool takes_step = false;
  unsigned char rows[kMostTerms] = {};
  double coefficients[kMostTerms] = {};
};

// Whether a stage of these coefficients takes the step. Static, so that it is shared with no other program
// part.
static constexpr bool are_small(const double* coefficients, int count) {
  double size = 0;
  for (int j = 0; j < count; ++j) size += coefficients[j] < 0 ? -coefficients[j] : coefficients[j];
  return size < 32;
}

// absolute + relative max(|y_i|, |end_i|); `stride` is 0 for one tolerance of all elements, 1 for one of
// each.
struct ErrorScale {
  const double *absolute, *relative;
  size_t stride;
};

// Puts f(t, y) into `rate`, `size` numbers.
struct RateFunction {
  void* object;
  void (*call)(void* object, double t, const double* y, double* rate, size_t size);
};

// `count` steps of one length, step i from t = origin + i · step; the first, i = first, from y and k[0] =
// f(t, y) to `end`, the next one back, and so on.
struct Steps {
  RateFunction rate;
  double origin, step;
  int64_t first, count;
  double *y, *end;
  double* const* k;
  double* stage;
  size_t size;   // of the state
  size_t lanes;  // of what is worked on, a multiple of `width`
};

// One kernel for each number of terms, so that the loop over them is unrolled; [0] is not used. Each works on
// the elements from `begin` to `end`, a multiple of `width` in number, at any address.
struct LaneKernels {
  size_t width;
  // out = y + h sum. `out` is apart from what is read.
  void (*combine[kMostTerms + 1])(const double* y, const double* const* k, const Sum& sum, double h,
                                  double* out, size_t begin, size_t end);
  // Of each of EveryMethod, compiled for its coefficients alone. The same bits as with `combine`.
  void (*const* steps)(const Steps& steps);
  bool (*are_finite)(const double* v, size_t begin, size_t end);
  // Of each estimate, running[i mod 4] += (sum_i · (1 / scale_i))², in the order of i. All estimates have the
  // rows of the first. None for AVX-512.
  void (*square_errors[kMostEstimates + 1][kMostTerms + 1])(const double* y, const double* y_end,
                                                            const double* const* k, const Sum* estimates,
                                                            const ErrorScale& scale,
                                                            double (*running)[kRunningSums], size_t begin,
                                                            size_t end);
};

extern const LaneKernels kLanesOne, kLanesSse2, kLanesAvx2, kLanesAvx512;

}  // namespace animado::fred
