// Collects instructions while an expression is read. What is constant is computed at once, and what was
// computed before is not computed again (value numbering): a definition that is used in ten places costs one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "interexpserv/instruction.hpp"
#include "interexpserv/table.hpp"
#include "interexpserv/units.hpp"
#include "interexpserv/value.hpp"

namespace animado::interexpserv {

// A value while it is being built: one register for each of its numbers.
struct Operand {
  Type type = Type::scalar;
  std::array<Register, 3> at{};
  Dimension dimension = kPlain;

  static Operand boolean(Register r) { return {Type::boolean, {r}, kPlain}; }
  static Operand scalar(Register r) { return {Type::scalar, {r}, kPlain}; }
  static Operand vector(Register x, Register y, Register z) { return {Type::vector, {x, y, z}, kPlain}; }
};

struct Input {
  std::string name;  // folded, dotted
  Type type = Type::scalar;
  bool operator==(const Input&) const = default;
};

constexpr size_t kMaxRegisters = 4096;  // 32 KiB on the stack of whoever evaluates

// What is left when everything that the result does not need is gone. Registers in order: constants, inputs,
// what instructions write; those that are no longer needed are written again.
struct CompiledCode {
  std::vector<double> constants;
  std::vector<Input> inputs;
  size_t input_count = 0;  // numbers: a vector is three
  std::vector<Instruction> instructions;
  size_t registers = 0;
  Operand result;
  std::shared_ptr<const std::vector<Table>> tables;  // null when there are none
};

class Builder {
 public:
  Builder();

  Register constant(double value);
  Operand constant(const Value& value);
  Operand input(const Input& input);
  // A number that is put in later, by substitute(): the argument of a function.
  Operand parameter(Type type);
  // A table's number, as a constant.
  Register table(Table table);

  Register apply(Op op, Register a, Register b, Register c);
  Register apply(Op op, Register a, Register b) { return apply(op, a, b, a); }
  Register apply(Op op, Register a) { return apply(op, a, a, a); }

  bool is_constant(Register r) const { return nodes_[r].kind == Kind::constant; }
  bool is_input(Register r) const { return nodes_[r].kind == Kind::input; }
  double value(Register r) const { return nodes_[r].value; }  // of a constant
  size_t size() const { return nodes_.size(); }

  // The numbers `of` with those of `parameters` replaced by `arguments`.
  Operand substitute(const Operand& of, const std::vector<Operand>& parameters,
                     const std::vector<Operand>& arguments);
  // ∂of/∂x, x an input or a parameter.
  Register derivative(Register of, Register x);

  CompiledCode finish(const Operand& result) const;

 private:
  enum class Kind : uint8_t { constant, input, instruction };
  struct Node {
    Kind kind;
    Instruction instruction;  // out: unused
    double value;             // of a constant
  };
  struct NamedInput {
    Input input;
    Operand operand;
  };
  Register append(const Node& node);
  Register find_or_append(const Node& node);
  size_t slot_of(const Node& node) const;
  Register simplified(Op op, Register a, Register b);
  Register slope(Op op, Register at, size_t operand);
  Register times_rate(Register slope, Register rate);
  std::vector<bool> needed_for(const Operand& result) const;

  std::vector<Node> nodes_;
  std::vector<Register> seen_;  // hash of a node → its register + 1; a power of two, at most half full
  std::vector<NamedInput> inputs_;
  std::vector<Table> tables_;
};

}  // namespace animado::interexpserv
