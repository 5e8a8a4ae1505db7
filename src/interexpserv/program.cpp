#include "interexpserv/program.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "interexpserv/elementary.hpp"

namespace animado::interexpserv {

Program::Program(std::string text, CompiledCode code) : text_(std::move(text)), code_(std::move(code)) {
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

namespace {

// A handful of numbers: a call of memcpy, which the compiler would make of this, takes longer.
inline double* copied(const double* from, size_t count, double* to) {
  for (const double* const end = from + count; from != end; ++from) {
    *to++ = *from;
    asm("" : "+r"(to));
  }
  return to;
}

}  // namespace

// The commonest operations are spelt out: a call costs as much as they do.
void Program::evaluate_many(const double* inputs, double* out) const noexcept {
  double r[kMaxRegisters];
  copied(inputs, code_.input_count, copied(code_.constants.data(), code_.constants.size(), r));
  for (const Instruction& i : code_.instructions) {
    switch (i.op) {
      case Op::add:
        r[i.out] = r[i.a] + r[i.b];
        break;
      case Op::subtract:
        r[i.out] = r[i.a] - r[i.b];
        break;
      case Op::multiply:
        r[i.out] = r[i.a] * r[i.b];
        break;
      case Op::divide:
        r[i.out] = r[i.a] / r[i.b];
        break;
      case Op::sqrt:
        r[i.out] = std::sqrt(r[i.a]);
        break;
      case Op::less:
        r[i.out] = r[i.a] < r[i.b];
        break;
      case Op::both:
        r[i.out] = (r[i.a] != 0) & (r[i.b] != 0);
        break;
      case Op::select:
        r[i.out] = r[r[i.a] != 0 ? i.b : i.c];
        break;
      case Op::sine:
        r[i.out] = sine(r[i.a]);
        break;
      case Op::cosine:
        r[i.out] = cosine(r[i.a]);
        break;
      case Op::exp:
        r[i.out] = exponential(r[i.a]);
        break;
      default:
        r[i.out] = value_of(i.op, r[i.a], r[i.b], r[i.c], code_.tables ? code_.tables->data() : nullptr);
    }
  }
  for (size_t k = 0; k < width_of(type()); ++k) out[k] = r[code_.result.at[k]];
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
