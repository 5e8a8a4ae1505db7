#include "interexpserv/builder.hpp"

#include <fmt/format.h>

#include <bit>

#include "base/error.hpp"

namespace animado::interexpserv {

Register Builder::append(Kind kind) {
  if (kinds_.size() == kMaxRegisters) {
    throw Error(Code::limit, fmt::format("an expression of more than {} operations", kMaxRegisters), {},
                "split it among several names or objects");
  }
  kinds_.push_back(kind);
  values_.push_back(0);
  instructions_.push_back({});
  return static_cast<Register>(kinds_.size() - 1);
}

Register Builder::constant(double value) {
  const auto bits = std::bit_cast<uint64_t>(value);
  if (const auto seen = constants_seen_.find(bits); seen != constants_seen_.end()) return seen->second;
  const Register r = append(Kind::constant);
  values_[r] = value;
  return constants_seen_[bits] = r;
}

Operand Builder::constant(const Value& value) {
  Operand operand{value.type, {}};
  for (size_t i = 0; i < width_of(value.type); ++i) operand.at[i] = constant(value.v[i]);
  return operand;
}

Operand Builder::input(const Input& input) {
  for (const NamedInput& known : inputs_) {
    if (known.input.name == input.name) return known.operand;
  }
  Operand operand{input.type, {}};
  for (size_t i = 0; i < width_of(input.type); ++i) operand.at[i] = append(Kind::input);
  inputs_.push_back({input, operand});
  return operand;
}

Register Builder::apply(Op op, Register a, Register b, Register c) {
  const std::array<uint16_t, 4> key = {static_cast<uint16_t>(op), a, b, c};
  if (const auto seen = seen_.find(key); seen != seen_.end()) return seen->second;
  Register r;
  if (op == Op::select && is_constant(a)) {
    r = values_[a] != 0 ? b : c;
  } else if (is_constant(a) && is_constant(b) && is_constant(c)) {
    r = constant(value_of(op, values_[a], values_[b], values_[c]));
  } else {
    r = append(Kind::instruction);
    instructions_[r] = {op, a, b, c};
  }
  return seen_[key] = r;
}

std::vector<bool> Builder::needed_for(const Operand& result) const {
  std::vector<bool> needed(kinds_.size(), false);
  for (size_t i = 0; i < width_of(result.type); ++i) needed[result.at[i]] = true;
  for (size_t r = kinds_.size(); r-- > 0;) {
    if (!needed[r] || kinds_[r] != Kind::instruction) continue;
    const Instruction& i = instructions_[r];
    needed[i.a] = needed[i.b] = needed[i.c] = true;
  }
  return needed;
}

CompiledCode Builder::finish(const Operand& result) const {
  const std::vector<bool> needed = needed_for(result);
  std::vector<Register> moved(kinds_.size(), 0);
  CompiledCode code;
  Register next = 0;
  for (size_t r = 0; r < kinds_.size(); ++r) {
    if (!needed[r] || kinds_[r] != Kind::constant) continue;
    code.constants.push_back(values_[r]);
    moved[r] = next++;
  }
  for (const NamedInput& known : inputs_) {
    bool used = false;
    for (size_t i = 0; i < width_of(known.input.type); ++i) used |= needed[known.operand.at[i]];
    if (!used) continue;
    code.inputs.push_back(known.input);
    for (size_t i = 0; i < width_of(known.input.type); ++i) moved[known.operand.at[i]] = next++;
  }
  code.input_count = next - code.constants.size();
  for (size_t r = 0; r < kinds_.size(); ++r) {
    if (!needed[r] || kinds_[r] != Kind::instruction) continue;
    const Instruction& i = instructions_[r];
    code.instructions.push_back({i.op, moved[i.a], moved[i.b], moved[i.c]});
    moved[r] = next++;
  }
  code.result.type = result.type;
  for (size_t i = 0; i < width_of(result.type); ++i) code.result.at[i] = moved[result.at[i]];
  return code;
}

}  // namespace animado::interexpserv
