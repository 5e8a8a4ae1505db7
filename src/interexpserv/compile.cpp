// Postfix nodes → program: types are checked, names resolved, definitions compiled in place.
#include <fmt/format.h>

#include <array>
#include <map>
#include <numbers>

#include "base/nearest_name.hpp"
#include "interexpserv/functions.hpp"
#include "interexpserv/parser.hpp"
#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kMaxDefinitions =
    100;  // definitions inside definitions: far above what is read with pleasure

struct Constant {
  std::string_view name;
  Value value;
};
const std::array<Constant, 4> kConstants = {{{"pi", Value::scalar(std::numbers::pi)},
                                             {"e", Value::scalar(std::numbers::e)},
                                             {"true", Value::boolean(true)},
                                             {"false", Value::boolean(false)}}};

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

std::string letters_of(std::span<const Operand> arguments) {
  std::string letters;
  for (const Operand& argument : arguments) letters += name_of(argument.type)[0];
  return letters;
}

std::string types_of(std::span<const Operand> arguments) {
  std::string text = "(";
  for (const Operand& argument : arguments) {
    if (text.size() > 1) text += ", ";
    text += name_of(argument.type);
  }
  return text + ")";
}

class Compiler {
 public:
  CompiledCode run(const Source& source, const Scope& scope, std::optional<Type> expected) {
    const Operand result = expression(source, scope);
    if (expected && result.type != *expected) {
      source.refuse(Code::type, 0,
                    fmt::format("a {} is needed, this is a {}", name_of(*expected), name_of(result.type)),
                    *expected == Type::vector ? "write a vector as (x, y, z)" : "");
    }
    return builder_.finish(result);
  }

 private:
  Operand expression(const Source& source, const Scope& scope) {
    std::vector<Operand> stack;
    for (const Node& node : parse(source)) {
      switch (node.kind) {
        case Node::Kind::number:
          stack.push_back(Operand::scalar(builder_.constant(node.number)));
          break;
        case Node::Kind::name:
          stack.push_back(name(node, source, scope));
          break;
        case Node::Kind::apply: {
          const size_t count = static_cast<size_t>(node.count);
          const Operand result = apply(node, std::span(stack).last(count), source, scope);
          stack.resize(stack.size() - count);
          stack.push_back(result);
        }
      }
    }
    return stack.back();
  }

  Operand name(const Node& node, const Source& source, const Scope& scope) {
    for (const auto& [constant, value] : kConstants) {
      if (node.name == constant) return builder_.constant(value);
    }
    if (const auto symbol = scope.find(node.name)) return operand_of(*symbol, node, source, scope);
    const size_t dot = node.name.rfind('.');
    const std::string last = dot == std::string::npos ? "" : node.name.substr(dot);
    if (last == ".x" || last == ".y" || last == ".z") {
      if (const auto symbol = scope.find(node.name.substr(0, dot))) {
        const std::array<Operand, 1> whole = {operand_of(*symbol, node, source, scope)};
        return apply({Node::Kind::apply, last, 0, 1, node.column + dot}, whole, source, scope);
      }
    }
    refuse_name(node, source, scope);
  }

  Operand operand_of(const Symbol& symbol, const Node& node, const Source& source, const Scope& scope) {
    if (const auto* value = std::get_if<Value>(&symbol)) return builder_.constant(*value);
    if (const auto* input = std::get_if<Input>(&symbol)) return builder_.input(*input);
    return definition(std::get<Definition>(symbol), node, source, scope.root());
  }

  Operand definition(const Definition& definition, const Node& node, const Source& source,
                     const Scope& root) {
    if (const auto done = defined_.find(definition.name); done != defined_.end()) return done->second;
    refuse_cycle(definition.name, node, source);
    if (open_.size() == kMaxDefinitions) {
      source.refuse(Code::limit, node.column,
                    fmt::format("more than {} names defined by each other", kMaxDefinitions));
    }
    open_.push_back(definition.name);
    try {
      const Source inner{definition.text, definition.name};
      const Operand result = definition.home.empty() ? expression(inner, root)
                                                     : expression(inner, HomeScope(root, definition.home));
      open_.pop_back();
      return defined_[definition.name] = result;
    } catch (const ExpressionError& error) {
      throw error.within(definition.name, node.column, source.where);
    }
  }

  Operand apply(const Node& node, std::span<const Operand> arguments, const Source& source,
                const Scope& scope) {
    if (!is_function(node.name)) refuse_function(node, source, scope);
    const Function* function = find_function(node.name, arguments);
    if (!function) refuse_types(node, arguments, source);
    return function->build(builder_, arguments);
  }

  void refuse_cycle(const std::string& name, const Node& node, const Source& source) const {
    const auto first = std::find(open_.begin(), open_.end(), name);
    if (first == open_.end()) return;
    std::string path;
    for (auto it = first; it != open_.end(); ++it) path += *it + " → ";
    source.refuse(Code::cycle, node.column, "names that need each other: " + path + name,
                  "define one of them by a value that does not need the others");
  }

  [[noreturn]] void refuse_name(const Node& node, const Source& source, const Scope& scope) const {
    if (is_function(node.name)) {
      source.refuse(Code::syntax, node.column, fmt::format("`{}` is a function", node.name),
                    fmt::format("write {}(…)", node.name));
    }
    std::vector<std::string> known = scope.known_names();
    for (const auto& [constant, value] : kConstants) known.emplace_back(constant);
    refuse_unknown(fmt::format("unknown name `{}`", node.name), node, source, known);
  }

  [[noreturn]] void refuse_function(const Node& node, const Source& source, const Scope& scope) const {
    if (scope.find(node.name)) {
      source.refuse(Code::syntax, node.column, fmt::format("`{}` is a value, not a function", node.name),
                    fmt::format("a product needs its sign: write {} * (…)", node.name));
    }
    std::vector<std::string> known;
    for (const Function& function : functions()) known.emplace_back(function.name);
    refuse_unknown(fmt::format("unknown function `{}`", node.name), node, source, known);
  }

  [[noreturn]] static void refuse_unknown(const std::string& what, const Node& node, const Source& source,
                                          const std::vector<std::string>& known) {
    const std::string near = nearest_name(node.name, known);
    source.refuse(Code::unknown_name, node.column, what,
                  near.empty() ? "" : fmt::format("did you mean `{}`?", near));
  }

  [[noreturn]] static void refuse_types(const Node& node, std::span<const Operand> arguments,
                                        const Source& source) {
    std::string remedy;
    for (const Meant& meant : kMeant) {
      if (meant.function == node.name && meant.types == letters_of(arguments)) remedy = meant.remedy;
    }
    std::string takes;
    for (const Function& function : functions()) {
      if (function.name != node.name) continue;
      takes += (takes.empty() ? "" : " or ") + signature_of(function);
    }
    source.refuse(Code::type, node.column,
                  fmt::format("`{}` takes {}, not {}", node.name, takes, types_of(arguments)), remedy);
  }

  Builder builder_;
  std::map<std::string, Operand> defined_;
  std::vector<std::string> open_;  // definitions being compiled, outermost first
};

}  // namespace

Program compile(std::string_view text, const Scope& scope, std::string_view where,
                std::optional<Type> expected) {
  const Source source{text, where};
  return {std::string(text), Compiler().run(source, scope, expected)};
}

}  // namespace animado::interexpserv
