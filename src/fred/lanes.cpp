// The kernels of lanes.hpp, four elements a turn: the same operations in the same order for each element, so
// the same bits, whether the machine takes them two or four at a time.
//
// The number of terms is known when compiling: coefficients stay in registers, and each derivative is read
// once. No standard header is included: an inline function compiled here for AVX2 must not become the copy
// that the linker keeps for the whole program.
#include "fred/lanes.hpp"

namespace animado::fred {
namespace {

using Lane = double __attribute__((vector_size(8 * kLaneGroup)));
using UnalignedLane = double __attribute__((vector_size(8 * kLaneGroup), aligned(8), may_alias));
using Mask = long long __attribute__((vector_size(8 * kLaneGroup)));

#define ANIMADO_INLINE [[gnu::always_inline]] inline

ANIMADO_INLINE const Lane& at(const double* p, size_t element) {
  return *reinterpret_cast<const Lane*>(p + element);
}

// A tolerance of each element, or one of all.
ANIMADO_INLINE Lane spread(const double* p, size_t element, size_t stride) {
  return stride ? *reinterpret_cast<const UnalignedLane*>(p + element) : Lane{} + *p;
}

ANIMADO_INLINE Lane larger_magnitude(Lane u, Lane v) {
  const Mask magnitude = Mask{} + 0x7fffffffffffffff;
  const Lane a = (Lane)((Mask)u & magnitude), b = (Lane)((Mask)v & magnitude);
  return a > b ? a : b;
}

template <int kTerms>
struct Terms {
  const double* k[kTerms];
  double coefficients[kTerms];

  ANIMADO_INLINE Terms(const double* const* derivatives, const Sum& sum) {
    for (int j = 0; j < kTerms; ++j) {
      k[j] = derivatives[sum.rows[j]];
      coefficients[j] = sum.coefficients[j];
    }
  }

  ANIMADO_INLINE Lane operator()(size_t element) const {
    Lane total = coefficients[0] * at(k[0], element);
#pragma GCC unroll 16
    for (int j = 1; j < kTerms; ++j) total += coefficients[j] * at(k[j], element);
    return total;
  }
};

template <int kTerms>
void combine(const double* y, const double* const* k, const Sum& sum, double h, double* out, size_t size) {
  const Terms<kTerms> terms(k, sum);
  for (size_t e = 0; e < size; e += kLaneGroup) {
    *reinterpret_cast<Lane*>(out + e) = at(y, e) + h * terms(e);
  }
}

template <int kTerms>
double square_error(const double* y, const double* end, const double* const* k, const Sum& sum,
                    const ErrorScale& scale, size_t size) {
  const Terms<kTerms> terms(k, sum);
  Lane total = {};
  for (size_t e = 0; e < size; e += kLaneGroup) {
    const Lane absolute = spread(scale.absolute, e, scale.stride);
    const Lane relative = spread(scale.relative, e, scale.stride);
    const Lane error = terms(e) / (absolute + relative * larger_magnitude(at(y, e), at(end, e)));
    total += error * error;
  }
  return (total[0] + total[1]) + (total[2] + total[3]);
}

}  // namespace

#define ANIMADO_OF_EACH_COUNT(kernel)                                                                 \
  {                                                                                                   \
    nullptr, kernel<1>, kernel<2>, kernel<3>, kernel<4>, kernel<5>, kernel<6>, kernel<7>, kernel<8>,  \
        kernel<9>, kernel<10>, kernel<11>, kernel<12>, kernel<13>, kernel<14>, kernel<15>, kernel<16> \
  }

const LaneKernels ANIMADO_LANE_KERNELS = {ANIMADO_OF_EACH_COUNT(combine),
                                          ANIMADO_OF_EACH_COUNT(square_error)};

}  // namespace animado::fred
