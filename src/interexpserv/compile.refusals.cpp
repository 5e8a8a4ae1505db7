#include "interexpserv/compile.refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "base/nearest_name.hpp"

namespace animado::interexpserv {

const std::array<Constant, 4> kConstants = {{{"pi", Value::scalar(std::numbers::pi)},
                                             {"e", Value::scalar(std::numbers::e)},
                                             {"true", Value::boolean(true)},
                                             {"false", Value::boolean(false)}}};

namespace {

// What is usually meant where types do not fit.
struct Meant {
  std::string_view function, types, remedy;
};
constexpr std::array<Meant, 12> kMeant = {
    {{"*", "vv", "write dot(a, b) or cross(a, b)"},
     {"^", "vs", "write dot(v, v) for the square of the length, norm(v)^n for a power of it"},
     {"+", "vs", "a vector needs three components: (x, y, z)"},
     {"+", "sv", "a vector needs three components: (x, y, z)"},
     {"-", "vs", "a vector needs three components: (x, y, z)"},
     {"-", "sv", "a vector needs three components: (x, y, z)"},
     {"/", "vv", "only a number divides: write v / norm(w)"},
     {"/", "sv", "only a number divides: write a / norm(v)"},
     {"abs", "v", "write norm(v) for the length"},
     {"norm", "s", "write abs(x)"},
     {"?:", "sss", "a condition is a comparison: write x != 0 ? a : b"},
     {"?:", "svv", "a condition is a comparison: write x != 0 ? a : b"}}};

std::string types_of(Items arguments) {
  std::string text = "(";
  for (const Item& argument : arguments) {
    if (text.size() > 1) text += ", ";
    text += argument.is_text() ? "text" : name_of(argument.operand.type);
  }
  return text + ")";
}

[[noreturn]] void refuse_unknown(const std::string& what, const Node& node, const Context& at,
                                 const std::vector<std::string>& known) {
  const std::string near = nearest_name(node.name, known);
  at.source.refuse(Code::unknown_name, node.column, what,
                   near.empty() ? "" : fmt::format("did you mean `{}`?", near));
}

}  // namespace

std::string letters_of(Items arguments) {
  std::string letters;
  for (const Item& item : arguments) letters += item.is_text() ? 't' : name_of(item.operand.type)[0];
  return letters;
}

const Operand* parameter(std::string_view name, const Context& at) {
  const auto found = std::find(at.parameters.begin(), at.parameters.end(), name);
  return found == at.parameters.end() ? nullptr
                                      : &at.values[static_cast<size_t>(found - at.parameters.begin())];
}

void refuse_text(const Node& node, const Context& at) {
  at.source.refuse(Code::type, node.column, fmt::format("a text is no value: `{}`", node.name),
                   "only table(\"file.csv\", x) takes one");
}

void refuse_name(const Node& node, const Context& at) {
  if (is_function(node.name)) {
    at.source.refuse(Code::syntax, node.column, fmt::format("`{}` is a function", node.name),
                     fmt::format("write {}(…)", node.name));
  }
  std::vector<std::string> known = at.scope.known_names();
  for (const auto& [constant, value] : kConstants) known.emplace_back(constant);
  known.insert(known.end(), at.parameters.begin(), at.parameters.end());
  refuse_unknown(fmt::format("unknown name `{}`", node.name), node, at, known);
}

void refuse_function(const Node& node, bool is_value, const Context& at) {
  if (is_value || parameter(node.name, at)) {
    at.source.refuse(Code::syntax, node.column, fmt::format("`{}` is a value, not a function", node.name),
                     fmt::format("a product needs its sign: write {} * (…)", node.name));
  }
  std::vector<std::string> known = at.scope.known_names();
  for (const Function& function : functions()) known.emplace_back(function.name);
  refuse_unknown(fmt::format("unknown function `{}`", node.name), node, at, known);
}

void refuse_types(const Node& node, Items arguments, const Context& at) {
  std::string remedy;
  for (const Meant& meant : kMeant) {
    if (meant.function == node.name && meant.types == letters_of(arguments)) remedy = meant.remedy;
  }
  std::string takes;
  for (const Function& function : functions()) {
    if (function.name != node.name) continue;
    takes += (takes.empty() ? "" : " or ") + signature_of(function);
  }
  at.source.refuse(Code::type, node.column,
                   fmt::format("`{}` takes {}, not {}", node.name, takes, types_of(arguments)), remedy);
}

}  // namespace animado::interexpserv
