// What names and expressions are worth now.
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/fold.hpp"
#include "interexpserv/names_lookup.hpp"

namespace animado::interexpserv {

Value Names::value(std::string_view name, const Numbers& numbers) const {
  const Entry& entry = known(name);
  if (entry.meaning.program) return run(*entry.meaning.program, numbers);
  if (entry.now.kind == Revision::Kind::definition) return entry.meaning.constant;
  Value value{entry.now.type, {}};
  read({fold(name), entry.now.type}, numbers, value.v.data());
  return value;
}

Value Names::evaluate(std::string_view text, std::string_view home, const Numbers& numbers) const {
  const Lookup scope(*this);
  return run(home.empty() ? compile(text, scope) : compile(text, HomeScope(scope, home)), numbers);
}

Value Names::run(const Program& program, const Numbers& numbers) const {
  std::vector<double> inputs(program.input_count());
  double* next = inputs.data();
  for (const Input& input : program.inputs()) {
    read(input, numbers, next);
    next += width_of(input.type);
  }
  Value value{program.type(), {}};
  program.evaluate(inputs.data(), value.v.data());
  return value;
}

void Names::read(const Input& input, const Numbers& numbers, double* out) const {
  const Entry* entry = find(input.name);
  if (!entry && input.name != "t") {
    throw Error(Code::unavailable, "a function has no value by itself", input.name, "call it: f(2)");
  }
  if (!entry) {  // only t may be used before it is bound
    throw Error(Code::unavailable, "t has no value: no run is going", input.name,
                "start a run, or leave t out");
  }
  const Binding& binding = entry->now.binding;
  const std::span<const double> array = numbers(binding.array);
  for (size_t k = 0; k < width_of(input.type); ++k) {
    const int64_t at = binding.element + static_cast<int64_t>(k) * binding.stride;
    if (at < 0 || at >= static_cast<int64_t>(array.size())) {
      throw Error(Code::bad_shape,
                  fmt::format("`{}` is bound to element {} of {}, which has {}", input.name, at,
                              binding.array, array.size()),
                  input.name, "bind it again");
    }
    out[k] = array[static_cast<size_t>(at)];
  }
}

}  // namespace animado::interexpserv
