// A compiled expression: sent once, evaluated where it is needed, for one or for many. It owns nothing
// outside itself and may be used by several threads at once.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interexpserv/builder.hpp"
#include "interexpserv/expression_error.hpp"
#include "interexpserv/scope.hpp"
#include "interexpserv/threaded.hpp"
#include "interexpserv/value.hpp"

namespace animado::interexpserv {

enum class InstructionSet { sse2, avx2, avx512 };
InstructionSet best_instruction_set();  // of this machine

// A number of each of many evaluations: a row of them, or one that all share.
struct Lanes {
  const double* values;
  bool shared = false;
};

class Program {
 public:
  Program(std::string text, CompiledCode code);

  Type type() const { return code_.result.type; }
  const Dimension& dimension() const { return code_.result.dimension; }  // plain when units do not tell
  const std::string& text() const { return text_; }

  // What it reads, in the order of first mention. A vector takes three numbers.
  const std::vector<Input>& inputs() const { return code_.inputs; }
  size_t input_count() const { return code_.input_count; }  // numbers
  bool is_constant() const { return code_.inputs.empty(); }
  Value constant() const;  // is_constant() only

  // inputs: input_count() numbers. out: one number, three of a vector; 0 or 1 of a boolean. IEEE 754: NaN and
  // infinity pass through. Allocates nothing.
  void evaluate(const double* inputs, double* out) const noexcept {
    if (single_) {
      evaluate_single(inputs, out);
    } else {
      evaluate_steps(inputs, out);
    }
  }

  // The same for `count` evaluations at once: the same bits, by vector instructions. inputs: input_count() of
  // them; out: a row of `count` numbers for each number of the result, none of them an input.
  void evaluate_batch(std::span<const Lanes> inputs, size_t count, std::span<double* const> out,
                      InstructionSet instructions = best_instruction_set()) const;

  // The value, and its rate of change while the inputs change with `input_rates` (a rate for "t", if it is
  // one, is 1). Exact to rounding; 0 for what jumps.
  void evaluate_with_rate(const double* inputs, const double* input_rates, double* out,
                          double* out_rate) const noexcept;

  // Whether both do the same to as many inputs and constants, whatever those are. Never so with tables.
  bool same_form(const Program& other) const;
  const std::vector<double>& constants() const { return code_.constants; }
  // This program with its constants as inputs, before the others: one for all of the same form.
  Program with_open_constants() const;

 private:
  void evaluate_single(const double* inputs, double* out) const noexcept;
  void evaluate_steps(const double* inputs, double* out) const noexcept;

  std::string text_;
  CompiledCode code_;
  std::vector<Step> steps_;
  // A program of one arithmetic operation is not worth two jumps. An operand is input `input`, or `constant`
  // when that is negative.
  struct Source {
    double constant;
    int input;
  };
  bool single_ = false;
  Op op_ = Op::add;
  Source a_{}, b_{};
};

inline void Program::evaluate_single(const double* inputs, double* out) const noexcept {
  const double a = *(a_.input < 0 ? &a_.constant : inputs + a_.input);
  const double b = *(b_.input < 0 ? &b_.constant : inputs + b_.input);
  if (op_ == Op::multiply) {
    *out = a * b;
  } else if (op_ == Op::add) {
    *out = a + b;
  } else {
    *out = op_ == Op::subtract ? a - b : a / b;
  }
}

// Reads `text` in `scope`. pi, e, true and false are known everywhere; t is known if the scope knows it.
// where: put before messages (file:line, a name). expected: the type that is needed, if only one is.
// A text of the form "(x, y) = expression" is a function: the program reads x and y, as the first types for
// which it can be read (scalars before vectors before booleans).
// Throws ExpressionError: syntax, type, unknown_name, cycle, limit; its column counts code points of `text`.
Program compile(std::string_view text, const Scope& scope, std::string_view where = {},
                std::optional<Type> expected = {});

}  // namespace animado::interexpserv
