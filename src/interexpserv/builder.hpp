// Collects instructions while an expression is read. What is constant is computed at once, and what was
// computed before is not computed again (value numbering): a definition that is used in ten places costs one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "interexpserv/instruction.hpp"
#include "interexpserv/value.hpp"

namespace animado::interexpserv {

// A value while it is being built: one register for each of its numbers.
struct Operand {
  Type type = Type::scalar;
  std::array<Register, 3> at{};

  static Operand boolean(Register r) { return {Type::boolean, {r}}; }
  static Operand scalar(Register r) { return {Type::scalar, {r}}; }
  static Operand vector(Register x, Register y, Register z) { return {Type::vector, {x, y, z}}; }
};

struct Input {
  std::string name;  // folded, dotted
  Type type = Type::scalar;
  bool operator==(const Input&) const = default;
};

constexpr size_t kMaxRegisters = 4096;  // 32 KiB on the stack of whoever evaluates

// What is left when everything that the result does not need is gone. Registers in order: constants, inputs,
// instructions.
struct CompiledCode {
  std::vector<double> constants;
  std::vector<Input> inputs;
  size_t input_count = 0;  // numbers: a vector is three
  std::vector<Instruction> instructions;
  Operand result;
};

class Builder {
 public:
  Register constant(double value);
  Operand constant(const Value& value);
  Operand input(const Input& input);
  Register apply(Op op, Register a, Register b, Register c);
  Register apply(Op op, Register a, Register b) { return apply(op, a, b, a); }
  Register apply(Op op, Register a) { return apply(op, a, a, a); }
  bool is_constant(Register r) const { return kinds_[r] == Kind::constant; }

  CompiledCode finish(const Operand& result) const;

 private:
  enum class Kind : uint8_t { constant, input, instruction };
  struct NamedInput {
    Input input;
    Operand operand;
  };
  Register append(Kind kind);
  std::vector<bool> needed_for(const Operand& result) const;

  std::vector<Kind> kinds_;
  std::vector<double> values_;             // of constants
  std::vector<Instruction> instructions_;  // of instructions
  std::vector<NamedInput> inputs_;
  std::map<uint64_t, Register> constants_seen_;  // by bit pattern: -0 is not 0
  std::map<std::array<uint16_t, 4>, Register> seen_;
};

}  // namespace animado::interexpserv
