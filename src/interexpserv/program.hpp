// A compiled expression: sent once, evaluated where it is needed. It owns nothing outside itself and may be
// used by several threads at once.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interexpserv/builder.hpp"
#include "interexpserv/expression_error.hpp"
#include "interexpserv/scope.hpp"
#include "interexpserv/value.hpp"

namespace animado::interexpserv {

class Program {
 public:
  Program(std::string text, CompiledCode code) : text_(std::move(text)), code_(std::move(code)) {}

  Type type() const { return code_.result.type; }
  const std::string& text() const { return text_; }

  // What it reads, in the order of first mention. A vector takes three numbers.
  const std::vector<Input>& inputs() const { return code_.inputs; }
  size_t input_count() const { return code_.input_count; }  // numbers
  bool is_constant() const { return code_.inputs.empty(); }
  Value constant() const;  // is_constant() only

  // inputs: input_count() numbers. out: one number, three of a vector; 0 or 1 of a boolean. IEEE 754: NaN and
  // infinity pass through. Allocates nothing.
  void evaluate(const double* inputs, double* out) const noexcept;

  // The value, and its rate of change while the inputs change with `input_rates` (a rate for "t", if it is
  // one, is 1). Exact to rounding; 0 for what jumps.
  void evaluate_with_rate(const double* inputs, const double* input_rates, double* out,
                          double* out_rate) const noexcept;

 private:
  std::string text_;
  CompiledCode code_;
};

// Reads `text` in `scope`. pi, e, true and false are known everywhere; t is known if the scope knows it.
// where: put before messages (file:line, a name). expected: the type that is needed, if only one is.
// Throws ExpressionError: syntax, type, unknown_name, cycle, limit; its column counts code points of `text`.
Program compile(std::string_view text, const Scope& scope, std::string_view where = {},
                std::optional<Type> expected = {});

}  // namespace animado::interexpserv
