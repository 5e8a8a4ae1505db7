#include "interexpserv/program.hpp"

#include <algorithm>
#include <cassert>

namespace animado::interexpserv {

Value Program::constant() const {
  assert(is_constant());
  Value value{type(), {}};
  evaluate(nullptr, value.v.data());
  return value;
}

void Program::evaluate(const double* inputs, double* out) const noexcept {
  double r[kMaxRegisters];
  double* next = std::copy(code_.constants.begin(), code_.constants.end(), r);
  next = std::copy(inputs, inputs + code_.input_count, next);
  for (const Instruction& i : code_.instructions) *next++ = value_of(i.op, r[i.a], r[i.b], r[i.c]);
  for (size_t k = 0; k < width_of(type()); ++k) out[k] = r[code_.result.at[k]];
}

void Program::evaluate_with_rate(const double* inputs, const double* input_rates, double* out,
                                 double* out_rate) const noexcept {
  double r[kMaxRegisters], rate[kMaxRegisters];
  size_t next = code_.constants.size();
  std::copy(code_.constants.begin(), code_.constants.end(), r);
  std::fill_n(rate, next, 0.0);
  std::copy(inputs, inputs + code_.input_count, r + next);
  std::copy(input_rates, input_rates + code_.input_count, rate + next);
  next += code_.input_count;
  for (const Instruction& i : code_.instructions) {
    r[next] = value_of(i.op, r[i.a], r[i.b], r[i.c]);
    rate[next] = rate_of(i.op, r[next], r[i.a], r[i.b], rate[i.a], rate[i.b], rate[i.c]);
    ++next;
  }
  for (size_t k = 0; k < width_of(type()); ++k) {
    out[k] = r[code_.result.at[k]];
    out_rate[k] = rate[code_.result.at[k]];
  }
}

}  // namespace animado::interexpserv
