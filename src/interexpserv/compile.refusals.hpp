// What a text says while it is compiled, and how its mistakes are told: caret, what was expected, what was
// probably meant.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/functions.hpp"
#include "interexpserv/parser.hpp"
#include "interexpserv/program.hpp"

namespace animado::interexpserv {

struct Constant {
  std::string_view name;
  Value value;
};
extern const std::array<Constant, 4> kConstants;

// A value on the stack of what is read, and the node that it comes from.
struct Item {
  const Node* node;
  Operand operand;
  bool is_text() const { return node->kind == Node::Kind::text; }
};
using Items = std::span<const Item>;

// Where a text is read: what its names mean.
struct Context {
  const Source& source;
  const Scope& scope;
  std::span<const std::string_view> parameters = {};  // of the function whose body it is
  std::span<const Operand> values = {};               // of those
};

// The value that a name stands for as a parameter; null when it is none.
const Operand* parameter(std::string_view name, const Context& at);

std::string letters_of(Items arguments);  // of their types: s, v, b; t for a text

// These throw ExpressionError at the node.
[[noreturn]] void refuse_text(const Node& node, const Context& at);  // where a value is needed
[[noreturn]] void refuse_name(const Node& node, const Context& at);  // unknown, or a function's
[[noreturn]] void refuse_function(const Node& node, bool is_value, const Context& at);
[[noreturn]] void refuse_types(const Node& node, Items arguments, const Context& at);

}  // namespace animado::interexpserv
