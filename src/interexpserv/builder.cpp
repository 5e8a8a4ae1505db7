#include "interexpserv/builder.hpp"

#include <fmt/format.h>

#include <bit>

#include "base/error.hpp"
#include "interexpserv/elementary.hpp"

namespace animado::interexpserv {
namespace {

constexpr Register kNone = 0xffff;

}  // namespace

Builder::Builder() : seen_(64, 0) {
  nodes_.reserve(32);
}

Register Builder::append(const Node& node) {
  if (nodes_.size() == kMaxRegisters) {
    throw Error(Code::limit, fmt::format("an expression of more than {} operations", kMaxRegisters), {},
                "split it among several names or objects");
  }
  nodes_.push_back(node);
  return static_cast<Register>(nodes_.size() - 1);
}

// Where in `seen_` the node stands or would stand.
size_t Builder::slot_of(const Node& node) const {
  const Instruction& i = node.instruction;
  const uint64_t key = node.kind == Kind::constant
                           ? std::bit_cast<uint64_t>(node.value)
                           : uint64_t{i.a} | uint64_t{i.b} << 16 | uint64_t{i.c} << 32 |
                                 uint64_t{static_cast<uint8_t>(i.op)} << 48;
  size_t slot = static_cast<size_t>((key * 0x9E3779B97F4A7C15) >> 32) & (seen_.size() - 1);
  for (; seen_[slot] != 0; slot = (slot + 1) & (seen_.size() - 1)) {
    const Node& other = nodes_[seen_[slot] - 1u];
    if (other.kind != node.kind) continue;
    const Instruction& o = other.instruction;
    const bool same = node.kind == Kind::constant  // by bit pattern: −0 is not 0
                          ? std::bit_cast<uint64_t>(other.value) == key
                          : o.op == i.op && o.a == i.a && o.b == i.b && o.c == i.c;
    if (same) break;
  }
  return slot;
}

Register Builder::find_or_append(const Node& node) {
  if (2 * nodes_.size() >= seen_.size()) {
    seen_.assign(4 * seen_.size(), 0);
    for (size_t r = 0; r < nodes_.size(); ++r) {
      if (nodes_[r].kind != Kind::input) seen_[slot_of(nodes_[r])] = static_cast<Register>(r + 1);
    }
  }
  const size_t slot = slot_of(node);
  if (seen_[slot] == 0) seen_[slot] = static_cast<Register>(append(node) + 1);
  return static_cast<Register>(seen_[slot] - 1);
}

Register Builder::constant(double value) {
  return find_or_append({Kind::constant, {}, value});
}

Operand Builder::constant(const Value& value) {
  Operand operand{value.type, {}, kPlain};
  for (size_t i = 0; i < width_of(value.type); ++i) operand.at[i] = constant(value.v[i]);
  return operand;
}

Operand Builder::input(const Input& input) {
  for (const NamedInput& known : inputs_) {
    if (known.input.name == input.name) return known.operand;
  }
  const Operand operand = parameter(input.type);
  inputs_.push_back({input, operand});
  return operand;
}

Operand Builder::parameter(Type type) {
  Operand operand{type, {}, kPlain};
  for (size_t i = 0; i < width_of(type); ++i) operand.at[i] = append({Kind::input, {}, 0});
  return operand;
}

Register Builder::table(Table table) {
  tables_.push_back(std::move(table));
  return constant(static_cast<double>(tables_.size() - 1));
}

// Powers that are products: exact to a rounding each, and many times as fast. A sign before a product or a
// quotient goes into a constant factor or divisor: the same bits, an operation less.
Register Builder::simplified(Op op, Register a, Register b) {
  if ((op == Op::multiply || op == Op::divide) && is_constant(b) && nodes_[a].kind == Kind::instruction &&
      nodes_[a].instruction.op == Op::negate) {
    const Register positive = nodes_[a].instruction.a;
    return apply(op, positive, constant(-value(b)));
  }
  if (op != Op::power || !is_constant(b)) return kNone;
  if (value(b) == 1) return a;
  if (value(b) == 2) return apply(Op::multiply, a, a);
  if (value(b) == 3) return apply(Op::multiply, apply(Op::multiply, a, a), a);
  if (value(b) == -1) return apply(Op::divide, constant(1.0), a);
  return kNone;
}

Register Builder::apply(Op op, Register a, Register b, Register c) {
  if (op == Op::select && (is_constant(a) || b == c)) return b == c || value(a) != 0 ? b : c;
  if (is_constant(a) && is_constant(b) && is_constant(c)) {
    return constant(value_of(op, value(a), value(b), value(c), tables_.data()));
  }
  const Register simple = simplified(op, a, b);
  return simple != kNone ? simple : find_or_append({Kind::instruction, {op, 0, a, b, c}, 0});
}

Operand Builder::substitute(const Operand& of, const std::vector<Operand>& parameters,
                            const std::vector<Operand>& arguments) {
  const std::vector<bool> needed = needed_for(of);
  std::vector<Register> now(needed.size());
  for (size_t r = 0; r < now.size(); ++r) now[r] = static_cast<Register>(r);
  for (size_t p = 0; p < parameters.size(); ++p) {
    for (size_t i = 0; i < width_of(parameters[p].type); ++i) now[parameters[p].at[i]] = arguments[p].at[i];
  }
  for (size_t r = 0; r < now.size(); ++r) {
    if (!needed[r] || nodes_[r].kind != Kind::instruction) continue;
    const Instruction i = nodes_[r].instruction;
    const Register a = now[i.a], b = now[i.b], c = now[i.c];
    if (a != i.a || b != i.b || c != i.c) now[r] = apply(i.op, a, b, c);
  }
  Operand result = of;
  for (size_t i = 0; i < width_of(of.type); ++i) result.at[i] = now[of.at[i]];
  return result;
}

std::vector<bool> Builder::needed_for(const Operand& result) const {
  std::vector<bool> needed(nodes_.size(), false);
  for (size_t i = 0; i < width_of(result.type); ++i) needed[result.at[i]] = true;
  for (size_t r = nodes_.size(); r-- > 0;) {
    if (!needed[r] || nodes_[r].kind != Kind::instruction) continue;
    const Instruction& i = nodes_[r].instruction;
    needed[i.a] = needed[i.b] = needed[i.c] = true;
  }
  return needed;
}

// Registers are dealt out by first need; who reads a value last sets its register free.
CompiledCode Builder::finish(const Operand& result) const {
  const std::vector<bool> needed = needed_for(result);
  std::vector<Register> moved(nodes_.size(), 0), last(nodes_.size(), 0);
  CompiledCode code;
  Register next = 0;
  size_t instructions = 0;
  for (size_t r = 0; r < nodes_.size(); ++r) {
    if (!needed[r]) continue;
    if (nodes_[r].kind == Kind::constant) {
      code.constants.push_back(nodes_[r].value);
      moved[r] = next++;
    } else if (nodes_[r].kind == Kind::instruction) {
      const Instruction& i = nodes_[r].instruction;
      last[i.a] = last[i.b] = last[i.c] = static_cast<Register>(r);
      ++instructions;
    }
  }
  for (const NamedInput& known : inputs_) {
    bool used = false;
    for (size_t i = 0; i < width_of(known.input.type); ++i) used |= needed[known.operand.at[i]];
    if (!used) continue;
    code.inputs.push_back(known.input);
    for (size_t i = 0; i < width_of(known.input.type); ++i) moved[known.operand.at[i]] = next++;
  }
  code.input_count = next - code.constants.size();
  for (size_t i = 0; i < width_of(result.type); ++i) last[result.at[i]] = kNone;
  std::vector<Register> free;
  code.instructions.reserve(instructions);
  for (size_t r = 0; r < nodes_.size(); ++r) {
    if (!needed[r] || nodes_[r].kind != Kind::instruction) continue;
    const Instruction& i = nodes_[r].instruction;
    const Instruction placed = {i.op, 0, moved[i.a], moved[i.b], moved[i.c]};
    for (const Register operand : {i.a, i.b, i.c}) {
      if (last[operand] != r || nodes_[operand].kind != Kind::instruction) continue;
      free.push_back(moved[operand]);
      last[operand] = kNone;
    }
    if (free.empty()) {
      moved[r] = next++;
    } else {
      moved[r] = free.back();
      free.pop_back();
    }
    code.instructions.push_back(placed);
    code.instructions.back().out = moved[r];
  }
  code.registers = next;
  code.result = result;
  for (size_t i = 0; i < width_of(result.type); ++i) code.result.at[i] = moved[result.at[i]];
  if (!tables_.empty()) code.tables = std::make_shared<const std::vector<Table>>(tables_);
  return code;
}

}  // namespace animado::interexpserv
