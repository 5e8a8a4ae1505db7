#include "egesp/examined.hpp"

#include <cmath>
#include <limits>

#include "base/finite.hpp"
#include "egesp/accuracy.hpp"
#include "egesp/dense_system.hpp"

namespace animado::egesp {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// System s of a batch, by itself.
struct Alone {
  std::vector<double> a, b, x;

  Alone(const Batch& batch, size_t s) : a(batch.n * batch.n), b(batch.n * batch.m) {
    for (size_t e = 0; e < a.size(); ++e)
      a[e] = batch.matrices[batch.interleaved ? e * batch.count + s : s * a.size() + e];
    for (size_t e = 0; e < b.size(); ++e)
      b[e] = batch.right_sides[batch.interleaved ? e * batch.count + s : s * b.size() + e];
    x = b;
  }
  void put_back(const Batch& batch, size_t s) const {
    for (size_t e = 0; e < x.size(); ++e)
      batch.solutions[batch.interleaved ? e * batch.count + s : s * x.size() + e] = x[e];
  }
};

}  // namespace

std::vector<Refusal> solve_examined(const Batch& batch, const PivotRule& rule, const Questions& questions,
                                    Examination& examination) {
  const bool errors = questions.residual || questions.refine;
  examination.backward_errors.assign(errors ? batch.count : 0, kNone);
  examination.reciprocal_conditions.assign(questions.condition ? batch.count : 0, kNone);
  std::vector<Refusal> refusals;
  for (size_t s = 0; s < batch.count; ++s) {
    Alone alone(batch, s);
    const DenseSystem system(alone.a, batch.n, rule);
    if (system.lu().factored()) system.solve(alone.x, batch.m);
    if (!system.lu().factored() || !all_finite(alone.x)) {
      refusals.push_back({s, system.lu().pivots()});
      std::ranges::fill(alone.x, kNone);
    } else {
      if (questions.refine) refine(system, alone.b, alone.x, batch.m);
      if (errors) examination.backward_errors[s] = backward_error(system, alone.b, alone.x, batch.m);
      if (questions.condition) examination.reciprocal_conditions[s] = reciprocal_condition(system);
    }
    alone.put_back(batch, s);
  }
  return refusals;
}

}  // namespace animado::egesp
