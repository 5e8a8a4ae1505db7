#include "interexpserv/elementary.hpp"

#include <cmath>

#include "interexpserv/lane_exp.hpp"
#include "interexpserv/lane_inverse.hpp"
#include "interexpserv/lane_random.hpp"
#include "interexpserv/lane_roots.hpp"
#include "interexpserv/lane_trig.hpp"

namespace animado::interexpserv {
namespace {

static_assert(kWidth == 1);

ANIMADO_INLINE Lane one(double x) {
  return Lane{x};
}

}  // namespace

double sine(double x) {
  return sine(one(x))[0];
}
double cosine(double x) {
  return cosine(one(x))[0];
}
double exponential(double x) {
  return exponential(one(x))[0];
}
double logarithm(double x) {
  return logarithm(one(x))[0];
}
double power(double x, double y) {
  return power(one(x), one(y))[0];
}

// The remainder with the sign of b: a − b ⌊a/b⌋, without its rounding errors (fmod is exact).
double floored_modulo(double a, double b) {
  const double r = std::fmod(a, b);
  return r != 0 && (r < 0) != (b < 0) ? r + b : r;
}

// clang-format off
double value_of(Op op, double a, double b, double c, const Table* tables) {
  switch (op) {
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return a / b;
    case Op::negate: return -a;
    case Op::power: return power(a, b);
    case Op::less: return a < b;
    case Op::less_equal: return a <= b;
    case Op::equal: return a == b;
    case Op::both: return a != 0 && b != 0;
    case Op::either: return a != 0 || b != 0;
    case Op::invert: return a == 0;
    case Op::select: return a != 0 ? b : c;
    case Op::sine: return sine(a);
    case Op::cosine: return cosine(a);
    case Op::tangent: return tangent(one(a))[0];
    case Op::arcsine: return arcsine(one(a))[0];
    case Op::arccosine: return arccosine(one(a))[0];
    case Op::arctangent: return arctangent(one(a))[0];
    case Op::arctangent2: return arctangent2(one(a), one(b))[0];
    case Op::sinh: return hyperbolic_sine(one(a))[0];
    case Op::cosh: return hyperbolic_cosine(one(a))[0];
    case Op::tanh: return hyperbolic_tangent(one(a))[0];
    case Op::exp: return exponential(a);
    case Op::log: return logarithm(a);
    case Op::log10: return decimal_logarithm(one(a))[0];
    case Op::sqrt: return std::sqrt(a);
    case Op::cbrt: return cube_root(one(a))[0];
    case Op::absolute: return std::fabs(a);
    case Op::sign: return a > 0 ? 1.0 : a < 0 ? -1.0 : a;
    case Op::floor: return std::floor(a);
    case Op::ceil: return std::ceil(a);
    case Op::round: return std::round(a);
    case Op::minimum: return a < b || std::isnan(a) ? a : b;  // a NaN on either side is not hidden
    case Op::maximum: return a > b || std::isnan(a) ? a : b;
    case Op::modulo: return floored_modulo(a, b);
    case Op::hypot: return hypotenuse(one(a), one(b))[0];
    case Op::random: return random_number(one(a), one(b), one(c))[0];
    case Op::table: return look_up(tables, b, a);
  }
  return kNaN;
}
// clang-format on

}  // namespace animado::interexpserv
