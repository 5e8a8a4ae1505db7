// Runs a tape over rows: an operation is one pass over a few cache lines. Compiled three times, with the name
// of the entry and the width of a register given by the build (see lane.hpp).
#include "interexpserv/lanes.hpp"

#include "interexpserv/lane_exp.hpp"
#include "interexpserv/lane_inverse.hpp"
#include "interexpserv/lane_random.hpp"
#include "interexpserv/lane_roots.hpp"
#include "interexpserv/lane_trig.hpp"

namespace animado::interexpserv {
namespace {

ANIMADO_INLINE Lane smaller(Lane a, Lane b) {
  return select((a < b) | is_nan(a), a, b);
}
ANIMADO_INLINE Lane larger(Lane a, Lane b) {
  return select((a > b) | is_nan(a), a, b);
}
ANIMADO_INLINE Lane direction(Lane a) {
  return select(a > 0.0, all(1.0), select(a < 0.0, all(-1.0), a));
}

struct Rows {
  const double *a, *b, *c;
  double* out;
  size_t lanes;

  template <class F>
  ANIMADO_INLINE void of_one(F f) const {
    for (size_t i = 0; i < lanes; i += kWidth) store(out + i, f(load(a + i)));
  }
  template <class F>
  ANIMADO_INLINE void of_two(F f) const {
    for (size_t i = 0; i < lanes; i += kWidth) store(out + i, f(load(a + i), load(b + i)));
  }
  template <class F>
  ANIMADO_INLINE void of_three(F f) const {
    for (size_t i = 0; i < lanes; i += kWidth) store(out + i, f(load(a + i), load(b + i), load(c + i)));
  }
};

#define ONE(expression) rows.of_one([](Lane a) __attribute__((always_inline)) { return expression; })
#define TWO(expression) rows.of_two([](Lane a, Lane b) __attribute__((always_inline)) { return expression; })
#define THREE(expression) \
  rows.of_three([](Lane a, Lane b, Lane c) __attribute__((always_inline)) { return expression; })

// clang-format off
ANIMADO_INLINE void run(Op op, const Rows& rows, const Table* tables) {
  switch (op) {
    case Op::add: return TWO(a + b);
    case Op::subtract: return TWO(a - b);
    case Op::multiply: return TWO(a * b);
    case Op::divide: return TWO(a / b);
    case Op::negate: return ONE(-a);
    case Op::power: return TWO(power(a, b));
    case Op::less: return TWO(truth(a < b));
    case Op::less_equal: return TWO(truth(a <= b));
    case Op::equal: return TWO(truth(a == b));
    case Op::both: return TWO(truth((a != 0.0) & (b != 0.0)));
    case Op::either: return TWO(truth((a != 0.0) | (b != 0.0)));
    case Op::invert: return ONE(truth(a == 0.0));
    case Op::select: return THREE(select(a != 0.0, b, c));
    case Op::sine: return ONE(sine(a));
    case Op::cosine: return ONE(cosine(a));
    case Op::tangent: return ONE(tangent(a));
    case Op::arcsine: return ONE(arcsine(a));
    case Op::arccosine: return ONE(arccosine(a));
    case Op::arctangent: return ONE(arctangent(a));
    case Op::arctangent2: return TWO(arctangent2(a, b));
    case Op::sinh: return ONE(hyperbolic_sine(a));
    case Op::cosh: return ONE(hyperbolic_cosine(a));
    case Op::tanh: return ONE(hyperbolic_tangent(a));
    case Op::exp: return ONE(exponential(a));
    case Op::log: return ONE(logarithm(a));
    case Op::log10: return ONE(decimal_logarithm(a));
    case Op::sqrt: return ONE(square_root(a));
    case Op::cbrt: return ONE(cube_root(a));
    case Op::absolute: return ONE(magnitude(a));
    case Op::sign: return ONE(direction(a));
    case Op::floor: return ONE(rounded_down(a));
    case Op::ceil: return ONE(rounded_up(a));
    case Op::round: return ONE(rounded(a));
    case Op::minimum: return TWO(smaller(a, b));
    case Op::maximum: return TWO(larger(a, b));
    case Op::hypot: return TWO(hypotenuse(a, b));
    case Op::random: return THREE(random_number(a, b, c));
    case Op::modulo:
      for (size_t i = 0; i < rows.lanes; ++i) rows.out[i] = floored_modulo(rows.a[i], rows.b[i]);
      return;
    case Op::table:
      for (size_t i = 0; i < rows.lanes; ++i) rows.out[i] = look_up(tables, rows.b[i], rows.a[i]);
      return;
  }
}
// clang-format on

}  // namespace

void ANIMADO_LANE_ENTRY(const LaneTape& tape) {
  for (const Instruction* i = tape.instructions; i != tape.instructions + tape.count; ++i) {
    run(i->op, {tape.rows[i->a], tape.rows[i->b], tape.rows[i->c], tape.rows[i->out], tape.lanes},
        tape.tables);
  }
}

}  // namespace animado::interexpserv
