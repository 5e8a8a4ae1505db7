// The kernels of lanes.hpp: the same operations in the same order for each element, so the same bits, whether
// the machine takes one, two, four or eight at a time.
//
// The number of terms is known when compiling: coefficients stay in registers, and each derivative is read
// once.
#include "fred/lanes.hpp"

#include "fred/lanes.steps.hpp"
#include "fred/lanes.vector.hpp"
#include "fred/tableaus/tableaus.hpp"

namespace animado::fred {
namespace {

template <int kTerms>
struct Terms {
  const double* k[kTerms];
  Lane coefficients[kTerms];

  ANIMADO_INLINE Terms(const double* const* derivatives, const Sum& sum, double factor = 1) {
#pragma GCC unroll 16
    for (int j = 0; j < kTerms; ++j) {
      k[j] = derivatives[sum.rows[j]];
      coefficients[j] = factor * sum.coefficients[j] - Lane{};  // in each place of the lane
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
void combine(const double* y, const double* const* k, const Sum& sum, double h, double* out, size_t begin,
             size_t end) {
  const Terms<kTerms> terms(k, sum, sum.takes_step ? h : 1);
  const double factor = sum.takes_step ? 1 : h;
  for (size_t e = begin; e < end; e += kWidth) put(out, e, at(y, e) + factor * terms(e));
}

#if ANIMADO_LANE_BYTES <= 32  // running sums come in fours

// A tolerance of each element, or one of all.
ANIMADO_INLINE Lane spread(const double* p, size_t element, size_t stride) {
  return stride ? at(p, element) : Lane{} + *p;
}

ANIMADO_INLINE Lane larger_magnitude(Lane u, Lane v) {
  const Lane a = u < 0 ? -u : u, b = v < 0 ? -v : v;
  return a > b ? a : b;
}

ANIMADO_INLINE Lane unit(const double* y, const double* y_end, const ErrorScale& scale, size_t element) {
  const Lane absolute = spread(scale.absolute, element, scale.stride);
  const Lane relative = spread(scale.relative, element, scale.stride);
  return absolute + relative * larger_magnitude(at(y, element), at(y_end, element));
}

// Calls add(element, which of the running sums it joins), as many elements a turn as there are sums.
template <class F>
ANIMADO_INLINE void for_each_lane(size_t begin, size_t end, const F& add) {
  for (size_t e = begin; e < end; e += kRunningSums) {
#pragma GCC unroll 4
    for (size_t i = 0; i < kRunningSums; i += kWidth) {
      if (e + i < end) add(e + i, i / kWidth);
    }
  }
}

struct RunningSums {
  Lane sums[kRunningSums / kWidth];
};

ANIMADO_INLINE RunningSums sums_from(const double* memory) {
  RunningSums running;
  for (size_t i = 0; i < kRunningSums; i += kWidth) running.sums[i / kWidth] = at(memory, i);
  return running;
}

ANIMADO_INLINE void put_sums(double* memory, const RunningSums& running) {
  for (size_t i = 0; i < kRunningSums; i += kWidth) put(memory, i, running.sums[i / kWidth]);
}

template <int kTerms>
void square_error(const double* y, const double* y_end, const double* const* k, const Sum* estimates,
                  const ErrorScale& scale, double (*running)[kRunningSums], size_t begin, size_t end) {
  const Terms<kTerms> terms(k, estimates[0]);
  RunningSums first = sums_from(running[0]);
  for_each_lane(
      begin, end, [&](size_t e, size_t i) __attribute__((always_inline)) {
        const Lane error = terms(e) * (1 / unit(y, y_end, scale, e));
        first.sums[i] += error * error;
      });
  put_sums(running[0], first);
}

template <int kTerms>
void square_two_errors(const double* y, const double* y_end, const double* const* k, const Sum* estimates,
                       const ErrorScale& scale, double (*running)[kRunningSums], size_t begin, size_t end) {
  const Terms<kTerms> terms(k, estimates[0]), others(k, estimates[1]);
  RunningSums first = sums_from(running[0]), second = sums_from(running[1]);
  for_each_lane(
      begin, end, [&](size_t e, size_t i) __attribute__((always_inline)) {
        const Lane inverse = 1 / unit(y, y_end, scale, e);
        const Lane error = terms(e) * inverse, other = others(e) * inverse;
        first.sums[i] += error * error;
        second.sums[i] += other * other;
      });
  put_sums(running[0], first);
  put_sums(running[1], second);
}

#endif

bool are_finite(const double* v, size_t begin, size_t end) {
  Lane sum = {};  // of 0 · v, which is 0, or NaN for what is not finite
  for (size_t e = begin; e < end; e += kWidth) sum += 0 * at(v, e);
  double lanes[kWidth], total = 0;
  put(lanes, 0, sum);
  for (const double lane : lanes) total += lane;
  return total == 0;
}

template <const auto&... kMethods>
struct StepsOf {
  static constexpr void (*kAll[])(const Steps&) = {take_steps<kMethods>...};
  constexpr StepsOf(ListOf<kMethods...>) {}
};

constexpr StepsOf kSteps = EveryMethod();

}  // namespace

#define ANIMADO_OF_EACH_COUNT(kernel)                                                                 \
  {                                                                                                   \
    nullptr, kernel<1>, kernel<2>, kernel<3>, kernel<4>, kernel<5>, kernel<6>, kernel<7>, kernel<8>,  \
        kernel<9>, kernel<10>, kernel<11>, kernel<12>, kernel<13>, kernel<14>, kernel<15>, kernel<16> \
  }

const LaneKernels ANIMADO_LANE_KERNELS = {
    kWidth,
    ANIMADO_OF_EACH_COUNT(combine),
    kSteps.kAll,
    are_finite,
#if ANIMADO_LANE_BYTES <= 32
    {{}, ANIMADO_OF_EACH_COUNT(square_error), ANIMADO_OF_EACH_COUNT(square_two_errors)}
#else
    {}
#endif
};

}  // namespace animado::fred
