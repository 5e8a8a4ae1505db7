// The machine that programs run on. It knows plain numbers only: a vector is three of them, a boolean is 0
// or 1. Every instruction writes a register of its own, once, and reads earlier ones.
//
// Each operation is a function of up to three numbers and of their rates of change: the rate of f(a, b) is
// ∂f/∂a · da + ∂f/∂b · db (forward-mode differentiation by dual numbers). IEEE 754 throughout: nothing is
// refused, NaN and infinity pass through.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace animado::interexpserv {

using Register = uint16_t;

// One line an operation.
// clang-format off
enum class Op : uint8_t {
  add, subtract, multiply, divide, negate, power,
  less, less_equal, equal, both, either, invert,  // yield booleans
  select,                                         // a ? b : c
  sine, cosine, tangent, arcsine, arccosine, arctangent, arctangent2,
  sinh, cosh, tanh, exp, log, log10, sqrt, cbrt,
  absolute, sign, floor, ceil, round, minimum, maximum, modulo, hypot,
};

struct Instruction {
  Op op;
  Register a, b, c;  // operands that the operation does not have repeat a
};

// The remainder with the sign of b: a − b ⌊a/b⌋, without its rounding errors.
inline double floored_modulo(double a, double b) {
  const double r = std::fmod(a, b);
  return r != 0 && (r < 0) != (b < 0) ? r + b : r;
}

inline double value_of(Op op, double a, double b, double c) {
  switch (op) {
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return a / b;
    case Op::negate: return -a;
    case Op::power: return std::pow(a, b);
    case Op::less: return a < b;
    case Op::less_equal: return a <= b;
    case Op::equal: return a == b;
    case Op::both: return a != 0 && b != 0;
    case Op::either: return a != 0 || b != 0;
    case Op::invert: return a == 0;
    case Op::select: return a != 0 ? b : c;
    case Op::sine: return std::sin(a);
    case Op::cosine: return std::cos(a);
    case Op::tangent: return std::tan(a);
    case Op::arcsine: return std::asin(a);
    case Op::arccosine: return std::acos(a);
    case Op::arctangent: return std::atan(a);
    case Op::arctangent2: return std::atan2(a, b);
    case Op::sinh: return std::sinh(a);
    case Op::cosh: return std::cosh(a);
    case Op::tanh: return std::tanh(a);
    case Op::exp: return std::exp(a);
    case Op::log: return std::log(a);
    case Op::log10: return std::log10(a);
    case Op::sqrt: return std::sqrt(a);
    case Op::cbrt: return std::cbrt(a);
    case Op::absolute: return std::fabs(a);
    case Op::sign: return a > 0 ? 1.0 : a < 0 ? -1.0 : a;
    case Op::floor: return std::floor(a);
    case Op::ceil: return std::ceil(a);
    case Op::round: return std::round(a);
    case Op::minimum: return a < b || std::isnan(a) ? a : b;  // a NaN on either side is not hidden
    case Op::maximum: return a > b || std::isnan(a) ? a : b;
    case Op::modulo: return floored_modulo(a, b);
    case Op::hypot: return std::hypot(a, b);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// A slope times a rate, where what stands still stays still even at an infinite slope (√x at 0).
inline double slope(double derivative, double rate) {
  return rate == 0 ? 0 : derivative * rate;
}

// The rate of `value` = value_of(op, a, b, c) when a, b, c change with da, db, dc. Zero where the value
// jumps.
inline double rate_of(Op op, double value, double a, double b, double da, double db, double dc) {
  switch (op) {
    case Op::add: return da + db;
    case Op::subtract: return da - db;
    case Op::multiply: return da * b + a * db;
    case Op::divide: return (da - value * db) / b;
    case Op::negate: return -da;
    case Op::power: return slope(b * std::pow(a, b - 1), da) + slope(value * std::log(a), db);
    case Op::less:
    case Op::less_equal:
    case Op::equal:
    case Op::both:
    case Op::either:
    case Op::invert: return 0;
    case Op::select: return a != 0 ? db : dc;
    case Op::sine: return slope(std::cos(a), da);
    case Op::cosine: return slope(-std::sin(a), da);
    case Op::tangent: return slope(1 + value * value, da);
    case Op::arcsine: return slope(1 / std::sqrt(1 - a * a), da);
    case Op::arccosine: return slope(-1 / std::sqrt(1 - a * a), da);
    case Op::arctangent: return slope(1 / (1 + a * a), da);
    case Op::arctangent2: return slope(b / (a * a + b * b), da) + slope(-a / (a * a + b * b), db);
    case Op::sinh: return slope(std::cosh(a), da);
    case Op::cosh: return slope(std::sinh(a), da);
    case Op::tanh: return slope(1 - value * value, da);
    case Op::exp: return slope(value, da);
    case Op::log: return slope(1 / a, da);
    case Op::log10: return slope(1 / (a * std::log(10.0)), da);
    case Op::sqrt: return slope(0.5 / value, da);
    case Op::cbrt: return slope(1 / (3 * value * value), da);
    case Op::absolute: return std::signbit(a) ? -da : da;
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::round: return 0;
    case Op::minimum: return a < b || std::isnan(a) ? da : db;
    case Op::maximum: return a > b || std::isnan(a) ? da : db;
    case Op::modulo: return da - slope(std::floor(a / b), db);
    case Op::hypot: return slope(a / value, da) + slope(b / value, db);
  }
  return std::numeric_limits<double>::quiet_NaN();
}
// clang-format on

}  // namespace animado::interexpserv
