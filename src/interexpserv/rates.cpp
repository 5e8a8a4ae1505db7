// Values and their rates of change together, by dual numbers: the rate of f(a, b) is ∂f/∂a · da + ∂f/∂b · db.
// Where only the derivative after one variable is wanted, d(f, x) in the text is quicker (derivative.cpp).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "interexpserv/elementary.hpp"
#include "interexpserv/program.hpp"
#include "interexpserv/table.hpp"

namespace animado::interexpserv {
namespace {

// A slope times a rate, where what stands still stays still even at an infinite slope (√x at 0).
double slope(double derivative, double rate) {
  return rate == 0 ? 0 : derivative * rate;
}

struct Dual {
  double value, rate;
};

// clang-format off
// The rate of `value` = value_of(op, a, b, c). Zero where the value jumps.
double rate_of(Op op, double value, const Dual& a, const Dual& b, const Dual& c, const Table* tables) {
  const double x = a.value, y = b.value, dx = a.rate, dy = b.rate;
  switch (op) {
    case Op::add: return dx + dy;
    case Op::subtract: return dx - dy;
    case Op::multiply: return dx * y + x * dy;
    case Op::divide: return (dx - value * dy) / y;
    case Op::negate: return -dx;
    case Op::power: return slope(y * power(x, y - 1), dx) + slope(value * logarithm(x), dy);
    case Op::less:
    case Op::less_equal:
    case Op::equal:
    case Op::both:
    case Op::either:
    case Op::invert: return 0;
    case Op::select: return x != 0 ? dy : c.rate;
    case Op::sine: return slope(cosine(x), dx);
    case Op::cosine: return slope(-sine(x), dx);
    case Op::tangent: return slope(1 + value * value, dx);
    case Op::arcsine: return slope(1 / std::sqrt(1 - x * x), dx);
    case Op::arccosine: return slope(-1 / std::sqrt(1 - x * x), dx);
    case Op::arctangent: return slope(1 / (1 + x * x), dx);
    case Op::arctangent2: return slope(y / (x * x + y * y), dx) + slope(-x / (x * x + y * y), dy);
    case Op::sinh: return slope(value_of(Op::cosh, x, 0, 0), dx);
    case Op::cosh: return slope(value_of(Op::sinh, x, 0, 0), dx);
    case Op::tanh: return slope(1 - value * value, dx);
    case Op::exp: return slope(value, dx);
    case Op::log: return slope(1 / x, dx);
    case Op::log10: return slope(1 / (x * std::numbers::ln10), dx);
    case Op::sqrt: return slope(0.5 / value, dx);
    case Op::cbrt: return slope(1 / (3 * value * value), dx);
    case Op::absolute: return std::signbit(x) ? -dx : dx;
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::round:
    case Op::random: return 0;
    case Op::minimum: return x < y || std::isnan(x) ? dx : dy;
    case Op::maximum: return x > y || std::isnan(x) ? dx : dy;
    case Op::modulo: return dx - slope(std::floor(x / y), dy);
    case Op::hypot: return slope(x / value, dx) + slope(y / value, dy);
    case Op::table: return slope(tables[static_cast<size_t>(y)].slope(x), dx);
  }
  return std::numeric_limits<double>::quiet_NaN();
}
// clang-format on

}  // namespace

void Program::evaluate_with_rate(const double* inputs, const double* input_rates, double* out,
                                 double* out_rate) const noexcept {
  Dual r[kMaxRegisters];
  const Table* tables = code_.tables ? code_.tables->data() : nullptr;
  Dual* next = r;
  for (const double value : code_.constants) *next++ = {value, 0};
  for (size_t i = 0; i < code_.input_count; ++i) *next++ = {inputs[i], input_rates[i]};
  for (const Instruction& i : code_.instructions) {
    const Dual a = r[i.a], b = r[i.b], c = r[i.c];
    const double value = value_of(i.op, a.value, b.value, c.value, tables);
    r[i.out] = {value, rate_of(i.op, value, a, b, c, tables)};
  }
  for (size_t k = 0; k < width_of(type()); ++k) {
    out[k] = r[code_.result.at[k]].value;
    out_rate[k] = r[code_.result.at[k]].rate;
  }
}

}  // namespace animado::interexpserv
