// Postfix nodes → program: types and dimensions are checked, names resolved, definitions compiled in place,
// functions compiled once for the types of their arguments and then put in.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <forward_list>
#include <map>

#include "interexpserv/compile.refusals.hpp"
#include "interexpserv/functions.hpp"
#include "interexpserv/parser.hpp"
#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kMaxDefinitions =
    100;                           // definitions inside definitions: far above what is read with pleasure
constexpr size_t kMaxGuessed = 5;  // parameters whose types are tried: 243 ways

// A function as far as it is known: compiled for these types.
struct Instance {
  std::string name, types;
  std::vector<Operand> parameters;
  Operand result;
};

class Compiler {
 public:
  CompiledCode run(const Source& source, const Scope& scope, std::optional<Type> expected) {
    const Operand result =
        is_function_text(source.text) ? open_function(source, scope) : expression({source, scope});
    if (expected && result.type != *expected) {
      source.refuse(Code::type, 0,
                    fmt::format("a {} is needed, this is a {}", name_of(*expected), name_of(result.type)),
                    *expected == Type::vector ? "write a vector as (x, y, z)" : "");
    }
    return builder_.finish(result);
  }

 private:
  Operand expression(const Context& at) { return body(parse(at.source), at); }

  Operand body(const Expression& parsed, const Context& at) {
    std::vector<Item> stack;
    stack.reserve(16);
    for (const Node& node : parsed.nodes) {
      switch (node.kind) {
        case Node::Kind::number:
          stack.push_back({&node, Operand::scalar(builder_.constant(node.number))});
          break;
        case Node::Kind::text:
          stack.push_back({&node, {}});
          break;
        case Node::Kind::name:
          stack.push_back({&node, name(node, at)});
          break;
        case Node::Kind::unit:
          stack.back().operand = with_unit(stack.back(), node, parsed, at);
          break;
        case Node::Kind::apply: {
          const size_t count = static_cast<size_t>(node.count);
          const Operand result = apply(node, Items(stack).last(count), at);
          stack.resize(stack.size() - count);
          stack.push_back({&node, result});
        }
      }
    }
    if (stack.back().is_text()) refuse_text(*stack.back().node, at);
    return stack.back().operand;
  }

  // --- names

  Operand name(const Node& node, const Context& at) {
    if (const Operand* value = parameter(node.name, at)) return *value;
    for (const auto& [constant, value] : kConstants) {
      if (node.name == constant) return builder_.constant(value);
    }
    if (const auto symbol = at.scope.find(node.name)) return operand_of(*symbol, node, at);
    const size_t dot = node.name.rfind('.');
    const std::string_view last = dot == std::string_view::npos ? "" : node.name.substr(dot);
    if (last == ".x" || last == ".y" || last == ".z") {
      const Node whole = {Node::Kind::name, node.name.substr(0, dot), 0, 0, node.column};
      const Operand* value = parameter(whole.name, at);
      const auto symbol = value ? std::nullopt : at.scope.find(whole.name);
      if (value || symbol) {
        const Item item = {&whole, value ? *value : operand_of(*symbol, whole, at)};
        return apply({Node::Kind::apply, last, 0, 1, node.column + dot}, {&item, 1}, at);
      }
    }
    refuse_name(node, at);
  }

  Operand operand_of(const Symbol& symbol, const Node& node, const Context& at) {
    if (const auto* value = std::get_if<Value>(&symbol)) return builder_.constant(*value);
    if (const auto* input = std::get_if<Input>(&symbol)) return builder_.input(*input);
    const auto& definition = std::get<Definition>(symbol);
    if (is_function_text(definition.text)) {
      at.source.refuse(Code::syntax, node.column, fmt::format("`{}` is a function", node.name),
                       fmt::format("write {}(…)", node.name));
    }
    if (const auto done = defined_.find(definition.name); done != defined_.end()) return done->second;
    const Operand result = inside(definition, node, at, [&](const Source& inner, const Scope& scope) {
      return expression({inner, scope});
    });
    return defined_[definition.name] = result;
  }

  // Reads a definition's text where it is at home; its errors tell who needed it.
  template <class Read>
  Operand inside(const Definition& definition, const Node& node, const Context& at, Read read) {
    refuse_cycle(definition.name, node, at);
    if (open_.size() == kMaxDefinitions) {
      at.source.refuse(Code::limit, node.column,
                       fmt::format("more than {} names defined by each other", kMaxDefinitions));
    }
    open_.push_back(definition.name);
    try {
      const Source inner{definition.text, definition.name};
      const Scope& root = at.scope.root();
      const Operand result =
          definition.home.empty() ? read(inner, root) : read(inner, HomeScope(root, definition.home));
      open_.pop_back();
      return result;
    } catch (const ExpressionError& error) {
      open_.resize(open_.size() - 1);
      throw error.within(definition.name, node.column, at.source.where);
    }
  }

  // --- functions

  Operand apply(const Node& node, Items arguments, const Context& at) {
    if (!is_function(node.name)) return call(node, arguments, at);
    std::array<Operand, 3> few;
    std::vector<Operand> many;
    std::span<Operand> operands = few;
    if (arguments.size() > few.size()) {
      many.resize(arguments.size());
      operands = many;
    }
    operands = operands.first(arguments.size());
    for (size_t i = 0; i < arguments.size(); ++i) operands[i] = arguments[i].operand;
    const bool texts = std::any_of(arguments.begin(), arguments.end(), [](auto& a) { return a.is_text(); });
    if (texts || node.name == "table") return table(node, arguments, at);
    const Function* function = find_function(node.name, operands);
    if (!function) refuse_types(node, arguments, at);
    try {
      const Dimension dimension = dimension_of(*function, builder_, operands);
      Operand result = function->build ? function->build(builder_, operands)
                                       : derivative(node, arguments, function->result, at);
      result.dimension = dimension;
      return result;
    } catch (const Misfit& misfit) {
      at.source.refuse(Code::type, node.column, misfit.what, misfit.remedy);
    }
  }

  Operand with_unit(const Item& of, const Node& node, const Expression& parsed, const Context& at) {
    const WrittenUnit& unit = parsed.units[static_cast<size_t>(node.count)];
    for (const Token& word : unit.further) {
      if (!parameter(word.text, at) && !at.scope.find(word.text)) continue;
      at.source.refuse(
          Code::conflict, word.column, fmt::format("`{}` is a unit and a name here", word.text),
          fmt::format("put blanks around the sign before it to mean the name, or choose another"));
    }
    if (of.is_text()) refuse_text(*of.node, at);
    if (of.operand.type == Type::boolean || of.operand.dimension.known) {
      at.source.refuse(Code::type, node.column, "a unit stands behind a number without one",
                       "write the number and its unit once: 10 cm");
    }
    Operand result = of.operand;
    for (size_t i = 0; i < width_of(result.type); ++i) {
      Register& r = result.at[i];
      if (unit.factor != 1) r = builder_.apply(Op::multiply, r, builder_.constant(unit.factor));
      if (unit.divisor != 1) r = builder_.apply(Op::divide, r, builder_.constant(unit.divisor));
    }
    result.dimension = unit.dimension;
    return result;
  }

  Operand derivative(const Node& node, Items arguments, Type type, const Context& at) {
    const Operand &of = arguments[0].operand, &after = arguments[1].operand;
    for (size_t i = 0; i < width_of(after.type); ++i) {
      if (arguments[1].node->kind == Node::Kind::name && builder_.is_input(after.at[i])) continue;
      const bool name = arguments[1].node->kind == Node::Kind::name;
      at.source.refuse(Code::type, arguments[1].node->column,
                       name ? fmt::format("`{}` does not vary by itself here", arguments[1].node->name)
                            : fmt::format("`{}` needs a variable to derive after", node.name),
                       "write d(f, t), or another name that is read and not computed");
    }
    Operand result{type, {}, kPlain};
    for (size_t i = 0; i < width_of(type); ++i) {
      result.at[i] = builder_.derivative(of.at[of.type == Type::vector ? i : 0],
                                         after.at[after.type == Type::vector ? i : 0]);
    }
    return result;
  }

  Operand table(const Node& node, Items arguments, const Context& at) {
    const std::string letters = letters_of(arguments);
    if (node.name != "table" || (letters != "ts" && letters != "tst")) refuse_types(node, arguments, at);
    const bool cubic = letters == "tst" && arguments[2].node->name == "cubic";
    if (letters == "tst" && !cubic && arguments[2].node->name != "linear") {
      at.source.refuse(Code::unknown_name, arguments[2].node->column,
                       fmt::format("unknown interpolation `{}`", arguments[2].node->name),
                       "it is linear or cubic");
    }
    const std::string path = at.scope.path_of(arguments[0].node->name);
    const std::string key = path + (cubic ? " cubic" : " linear");
    auto known = tables_.find(key);
    if (known == tables_.end()) {
      try {
        const auto way = cubic ? Interpolation::cubic : Interpolation::linear;
        known = tables_.emplace(key, builder_.table(read_table(path, way))).first;
      } catch (const Error& error) {
        at.source.refuse(error.code(), arguments[0].node->column,
                         error.where().empty() || error.where() == path
                             ? error.message()
                             : fmt::format("{}: {}", error.where(), error.message()),
                         error.remedy());
      }
    }
    return Operand::scalar(builder_.apply(Op::table, arguments[1].operand.at[0], known->second));
  }

  // A function of the scope: compiled once for the types of the arguments, these put in for its parameters.
  Operand call(const Node& node, Items arguments, const Context& at) {
    const auto symbol = at.scope.find(node.name);
    const auto* definition = symbol ? std::get_if<Definition>(&*symbol) : nullptr;
    if (!definition || !is_function_text(definition->text)) refuse_function(node, symbol.has_value(), at);
    std::vector<Operand> values;
    for (const Item& item : arguments) {
      if (item.is_text()) refuse_text(*item.node, at);
      values.push_back(item.operand);
    }
    const Instance& known = instance(*definition, values, node, arguments, at);
    Operand result = builder_.substitute(known.result, known.parameters, values);
    result.dimension = known.result.dimension;
    return result;
  }

  const Instance& instance(const Definition& definition, const std::vector<Operand>& values, const Node& node,
                           Items arguments, const Context& at) {
    std::string types = letters_of(arguments);
    for (const Operand& value : values) types += fmt::format(" {}", text_of(value.dimension));
    for (const Instance& known : instances_) {
      if (known.name == definition.name && known.types == types) return known;
    }
    Instance made{definition.name, types, {}, {}};
    made.result = inside(definition, node, at, [&](const Source& inner, const Scope& scope) {
      const Expression parsed = parse(inner);
      if (parsed.parameters.size() != values.size()) {
        at.source.refuse(Code::type, node.column,
                         fmt::format("`{}` takes {} value{}, not {}", node.name, parsed.parameters.size(),
                                     parsed.parameters.size() == 1 ? "" : "s", values.size()),
                         fmt::format("it is {}{}", node.name, definition.text));
      }
      made.parameters = parameters(values);
      return body(parsed, {inner, scope, parsed.parameters, made.parameters});
    });
    instances_.push_front(std::move(made));
    return instances_.front();
  }

  std::vector<Operand> parameters(std::span<const Operand> like) {
    std::vector<Operand> made;
    for (const Operand& value : like) {
      made.push_back(builder_.parameter(value.type));
      made.back().dimension = value.dimension;
    }
    return made;
  }

  // A function by itself: for the first types of its parameters for which it can be read.
  Operand open_function(const Source& source, const Scope& scope) {
    const Expression parsed = parse(source);
    const size_t count = parsed.parameters.size();
    std::optional<ExpressionError> first;
    const int combinations = count <= kMaxGuessed ? static_cast<int>(std::pow(3.0, count)) : 1;
    for (int k = 0; k < combinations; ++k) {
      builder_ = Builder();
      defined_.clear();
      instances_.clear();
      tables_.clear();
      std::vector<Operand> values;
      int rest = k;
      for (const std::string_view name : parsed.parameters) {
        constexpr std::array kTypes = {Type::scalar, Type::vector, Type::boolean};
        values.push_back(builder_.input({std::string(name), kTypes[static_cast<size_t>(rest % 3)]}));
        rest /= 3;
      }
      try {
        return body(parsed, {source, scope, parsed.parameters, values});
      } catch (const ExpressionError& error) {
        if (error.code() != Code::type) throw;
        if (!first) first = error;
      }
    }
    throw *first;
  }

  void refuse_cycle(const std::string& name, const Node& node, const Context& at) const {
    const auto first = std::find(open_.begin(), open_.end(), name);
    if (first == open_.end()) return;
    std::string path;
    for (auto it = first; it != open_.end(); ++it) path += *it + " → ";
    at.source.refuse(Code::cycle, node.column, "names that need each other: " + path + name,
                     "define one of them by a value that does not need the others");
  }

  Builder builder_;
  std::map<std::string, Operand, std::less<>> defined_;
  std::map<std::string, Register> tables_;  // by path and interpolation
  std::forward_list<Instance> instances_;
  std::vector<std::string> open_;  // definitions being compiled, outermost first
};

}  // namespace

Program compile(std::string_view text, const Scope& scope, std::string_view where,
                std::optional<Type> expected) {
  const Source source{text, where};
  return {std::string(text), Compiler().run(source, scope, expected)};
}

}  // namespace animado::interexpserv
