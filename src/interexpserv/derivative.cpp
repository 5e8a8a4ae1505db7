// ∂f/∂x of what a builder holds: the chain rule over its instructions, each of them once. What the derivative
// shares with the function, and with itself, is not computed again; the derivative of a derivative is as
// good.
//
//     dr = Σ_k ∂op/∂operand_k · d operand_k
//
// Jumps (floor, comparisons, random numbers) have the derivative 0. What stands still stays still even at an
// infinite slope: d √u = 0 where du = 0.
#include <algorithm>
#include <numbers>

#include "interexpserv/builder.hpp"

namespace animado::interexpserv {
namespace {

constexpr Register kZero = 0xffff;  // a derivative that is 0 everywhere

size_t operands_of(Op op) {
  switch (op) {
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::power:
    case Op::arctangent2:
    case Op::minimum:
    case Op::maximum:
    case Op::modulo:
    case Op::hypot:
      return 2;
    default:
      return 1;
  }
}

bool has_infinite_slopes(Op op) {
  constexpr std::array kOps = {Op::power, Op::arcsine, Op::arccosine, Op::arctangent2, Op::log,
                               Op::log10, Op::sqrt,    Op::cbrt,      Op::hypot};
  return std::find(kOps.begin(), kOps.end(), op) != kOps.end();
}

}  // namespace

// clang-format off
// ∂op/∂operand, where `at` is the register of the operation.
Register Builder::slope(Op op, Register at, size_t operand) {
  const Register a = nodes_[at].instruction.a, b = nodes_[at].instruction.b;
  const bool first = operand == 0;
  const auto k = [&](double value) { return constant(value); };
  const auto times = [&](Register u, Register v) { return apply(Op::multiply, u, v); };
  const auto over = [&](Register u, Register v) { return apply(Op::divide, u, v); };
  const auto plus = [&](Register u, Register v) { return apply(Op::add, u, v); };
  const auto minus = [&](Register u, Register v) { return apply(Op::subtract, u, v); };
  switch (op) {
    case Op::add: return k(1);
    case Op::subtract: return k(first ? 1 : -1);
    case Op::multiply: return first ? b : a;
    case Op::divide: return first ? over(k(1), b) : apply(Op::negate, over(at, b));
    case Op::negate: return k(-1);
    case Op::power:
      return first ? times(b, apply(Op::power, a, minus(b, k(1)))) : times(at, apply(Op::log, a));
    case Op::sine: return apply(Op::cosine, a);
    case Op::cosine: return apply(Op::negate, apply(Op::sine, a));
    case Op::tangent: return plus(k(1), times(at, at));
    case Op::arcsine: return over(k(1), apply(Op::sqrt, minus(k(1), times(a, a))));
    case Op::arccosine: return over(k(-1), apply(Op::sqrt, minus(k(1), times(a, a))));
    case Op::arctangent: return over(k(1), plus(k(1), times(a, a)));
    case Op::arctangent2: {
      const Register square = plus(times(a, a), times(b, b));
      return first ? over(b, square) : apply(Op::negate, over(a, square));
    }
    case Op::sinh: return apply(Op::cosh, a);
    case Op::cosh: return apply(Op::sinh, a);
    case Op::tanh: return minus(k(1), times(at, at));
    case Op::exp: return at;
    case Op::log: return over(k(1), a);
    case Op::log10: return over(k(1 / std::numbers::ln10), a);
    case Op::sqrt: return over(k(0.5), at);
    case Op::cbrt: return over(k(1), times(k(3), times(at, at)));
    case Op::absolute: return apply(Op::select, apply(Op::less, a, k(0)), k(-1), k(1));
    case Op::minimum: return apply(Op::select, apply(Op::less, a, b), k(first), k(!first));
    case Op::maximum: return apply(Op::select, apply(Op::less, b, a), k(first), k(!first));
    case Op::modulo: return first ? k(1) : apply(Op::negate, apply(Op::floor, over(a, b)));
    case Op::hypot: return over(first ? a : b, at);
    case Op::table: return apply(Op::table, a, table(tables_[static_cast<size_t>(value(b))].derivative()));
    case Op::less:
    case Op::less_equal:
    case Op::equal:
    case Op::both:
    case Op::either:
    case Op::invert:
    case Op::select:
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::round:
    case Op::random: return kZero;
  }
  return kZero;
}
// clang-format on

Register Builder::times_rate(Register slope, Register rate) {
  if (is_constant(rate) && value(rate) == 1) return slope;
  if (is_constant(slope) && value(slope) == 1) return rate;
  return apply(Op::multiply, slope, rate);
}

Register Builder::derivative(Register of, Register x) {
  const std::vector<bool> needed = needed_for(Operand::scalar(of));
  std::vector<Register> rates(needed.size(), kZero);
  if (needed[x]) rates[x] = constant(1.0);
  const auto or_zero = [&](Register rate) { return rate == kZero ? constant(0.0) : rate; };
  for (size_t r = 0; r < needed.size(); ++r) {
    if (!needed[r] || nodes_[r].kind != Kind::instruction) continue;
    const Instruction i = nodes_[r].instruction;
    if (i.op == Op::select) {
      if (rates[i.b] != kZero || rates[i.c] != kZero) {
        rates[r] = apply(Op::select, i.a, or_zero(rates[i.b]), or_zero(rates[i.c]));
      }
      continue;
    }
    for (size_t operand = 0; operand < operands_of(i.op); ++operand) {
      const Register rate = rates[operand == 0 ? i.a : i.b];
      if (rate == kZero || (is_constant(rate) && value(rate) == 0)) continue;
      const Register steep = slope(i.op, static_cast<Register>(r), operand);
      if (steep == kZero) continue;
      Register part = times_rate(steep, rate);
      if (has_infinite_slopes(i.op) && !is_constant(rate)) {
        part = apply(Op::select, apply(Op::equal, rate, constant(0.0)), constant(0.0), part);
      }
      rates[r] = rates[r] == kZero ? part : apply(Op::add, rates[r], part);
    }
  }
  return or_zero(rates[of]);
}

}  // namespace animado::interexpserv
