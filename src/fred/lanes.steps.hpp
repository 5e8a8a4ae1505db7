// The steps of one method as one function, with its coefficients as constants: what counts where the rate is
// quick is how many instructions stand between two evaluations.
#pragma once

#include "fred/lanes.hpp"
#include "fred/lanes.vector.hpp"

namespace animado::fred {
namespace {

// The coefficients that are not zero of what leads to stage s of a method, or to the end of the step.
template <const auto& kMethod, int s>
struct Row {
  int count = 0, rows[kMethod.kStages] = {};
  double coefficients[kMethod.kStages] = {};
  bool takes_step = false;

  constexpr Row() {
    for (int j = 0; j < kMethod.kStages; ++j) {
      const double a = s == kMethod.kStages ? kMethod.weights[j] : kMethod.matrix[s][j];
      if (a == 0) continue;
      rows[count] = j;
      coefficients[count++] = a;
    }
    takes_step = s < kMethod.kStages && are_small(coefficients, count);
  }
};

template <const auto& kMethod, int s>
constexpr Row<kMethod, s> kRow;

ANIMADO_INLINE Lane add(const double*, Lane total, size_t) {
  return total;
}

template <class... Rates>
ANIMADO_INLINE Lane add(const double* coefficients, Lane total, size_t element, const double* k,
                        Rates... others) {
  return add(coefficients + 1, total + *coefficients * at(k, element), element, others...);
}

// Its rates are told one after the other: what stands in an array is read from memory again.
template <const auto& kSum, class... Rates>
ANIMADO_INLINE void combine_row(const Steps& s, const double* y, double* out, const double* first,
                                Rates... others) {
  if constexpr (1 + sizeof...(others) < kSum.count) {
    combine_row<kSum>(s, y, out, first, others..., s.k[kSum.rows[1 + sizeof...(others)]]);
  } else if constexpr (kSum.takes_step) {
    double c[kSum.count];
    for (int j = 0; j < kSum.count; ++j) c[j] = s.step * kSum.coefficients[j];
    for (size_t e = 0; e < s.lanes; e += kWidth) {
      put(out, e, at(y, e) + add(c + 1, c[0] * at(first, e), e, others...));
    }
  } else {
    constexpr const double* c = kSum.coefficients;
    for (size_t e = 0; e < s.lanes; e += kWidth) {
      put(out, e, at(y, e) + s.step * add(c + 1, c[0] * at(first, e), e, others...));
    }
  }
}

// From stage s on.
template <const auto& kMethod, int s>
ANIMADO_INLINE void take_step(const Steps& steps, double t, const double* y, double* end) {
  constexpr bool kIsEnd = s == kMethod.kStages;
  constexpr const auto& kSum = kRow<kMethod, s>;
  combine_row<kSum>(steps, y, kIsEnd ? end : steps.stage, steps.k[kSum.rows[0]]);
  if constexpr (!kIsEnd) {
    const double at_stage = t + kMethod.nodes[s] * steps.step;
    steps.rate.call(steps.rate.object, at_stage, steps.stage, steps.k[s], steps.size);
    take_step<kMethod, s + 1>(steps, t, y, end);
  }
}

template <const auto& kMethod>
void take_steps(const Steps& given) {
  const Steps steps = given;  // in registers
  double *y = steps.y, *end = steps.end;
  for (int64_t i = 0;;) {
    const double t = steps.origin + static_cast<double>(steps.first + i) * steps.step;
    if (i > 0) steps.rate.call(steps.rate.object, t, y, steps.k[0], steps.size);
    take_step<kMethod, 1>(steps, t, y, end);
    if (++i == steps.count) return;
    double* const next = y;
    y = end;
    end = next;
  }
}

}  // namespace
}  // namespace animado::fred
