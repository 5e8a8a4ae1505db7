// Tokens → postfix nodes: operands before what is applied to them, so that whoever reads them needs a stack
// and no recursion.
#pragma once

#include <string>
#include <vector>

#include "interexpserv/expression_error.hpp"

namespace animado::interexpserv {

struct Node {
  enum class Kind {
    number,  // `number`
    name,    // `name`, dotted: "ball.position.y"
    apply,   // function or operator `name` of the `count` values before: "sin", "+", "?:", "(,,)", ".x"
  };
  Kind kind;
  std::string name;
  double number = 0;
  int count = 0;
  size_t column = 0;  // 0-based code point where it stands in the text
};

constexpr int kMaxNesting = 200;  // parentheses, calls, signs and powers inside each other

// Throws ExpressionError: syntax, limit.
std::vector<Node> parse(const Source& source);

// Words of the language, which name nothing else: and or not true false deg pi e t.
bool is_reserved(std::string_view folded_word);

}  // namespace animado::interexpserv
