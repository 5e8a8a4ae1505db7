#include "interexpserv/program.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "interexpserv/elementary.hpp"

namespace animado::interexpserv {

Program::Program(std::string text, CompiledCode code)
    : text_(std::move(text)), code_(std::move(code)), steps_(threaded(code_)) {
  if (code_.instructions.size() != 1) return;
  const Instruction& i = code_.instructions[0];
  single_ = code_.result.type != Type::vector &&
            (i.op == Op::add || i.op == Op::subtract || i.op == Op::multiply || i.op == Op::divide);
  const size_t constants = code_.constants.size();
  const auto source = [&](Register r) {
    return r < constants ? Source{code_.constants[r], -1} : Source{0, static_cast<int>(r - constants)};
  };
  op_ = i.op;
  if (single_) a_ = source(i.a), b_ = source(i.b);
}

Value Program::constant() const {
  assert(is_constant());
  Value value{type(), {}};
  evaluate(nullptr, value.v.data());
  return value;
}

void Program::evaluate_steps(const double* inputs, double* out) const noexcept {
  double results[kMaxRegisters];
  const Frame frame = {{code_.constants.data(), inputs, results, results},
                       results,
                       out,
                       code_.tables ? code_.tables->data() : nullptr};
  steps_[0].run(0, steps_.data(), frame);
}

bool Program::same_form(const Program& other) const {
  const CompiledCode &a = code_, &b = other.code_;
  const auto same = [](const Instruction& u, const Instruction& v) {
    return u.op == v.op && u.out == v.out && u.a == v.a && u.b == v.b && u.c == v.c;
  };
  return a.input_count == b.input_count && !a.tables && !b.tables && a.result.type == b.result.type &&
         a.result.at == b.result.at && a.constants.size() == b.constants.size() &&
         std::equal(a.instructions.begin(), a.instructions.end(), b.instructions.begin(),
                    b.instructions.end(), same);
}

Program Program::with_open_constants() const {
  CompiledCode open = code_;
  std::vector<Input> inputs;
  for (size_t k = 0; k < code_.constants.size(); ++k) inputs.push_back({fmt::format("constant {}", k)});
  open.inputs.insert(open.inputs.begin(), inputs.begin(), inputs.end());
  open.input_count +=
      open.constants.size();  // registers stay what they are: constants come first, then inputs
  open.constants.clear();
  return {text_, std::move(open)};
}

}  // namespace animado::interexpserv
