// Tokens → postfix nodes: operands before what is applied to them, so that whoever reads them needs a stack
// and no recursion.
#pragma once

#include <forward_list>
#include <string>
#include <vector>

#include "interexpserv/lexer.hpp"
#include "interexpserv/units.hpp"

namespace animado::interexpserv {

struct Node {
  enum class Kind {
    number,  // `number`
    text,    // `name`, as written between quotes, or a word that a function asks for
    name,    // `name`, dotted: "ball.position.y"
    unit,    // `units[count]` of the value before
    apply,   // function or operator `name` of the `count` values before: "sin", "+", "?:", "(,,)", ".x"
  };
  Kind kind;
  std::string_view name;
  double number = 0;
  int count = 0;
  size_t column = 0;  // 0-based code point where it stands in the text
};

// m/s^2: the value is multiplied by factor / divisor.
struct WrittenUnit {
  double factor = 1, divisor = 1;
  Dimension dimension = kOne;
  std::vector<Token> further;  // behind the first: words that might also be names
};

struct Expression {
  Tokens tokens;                             // what the names are parts of
  std::forward_list<std::string> spaced;     // names that are written with blanks at their dots
  std::vector<std::string_view> parameters;  // of a function, "(x, y) = …"
  std::vector<WrittenUnit> units;
  std::vector<Node> nodes;

  auto begin() const { return nodes.begin(); }
  auto end() const { return nodes.end(); }
};

constexpr int kMaxNesting = 200;  // parentheses, calls, signs and powers inside each other
constexpr size_t kMaxParameters = 8;

// Throws ExpressionError: syntax, limit.
Expression parse(const Source& source);

// Whether the text is a function's: "(x, y) = …". Nothing is thrown.
bool is_function_text(std::string_view text);

// Words of the language, which name nothing else: and or not true false deg pi e t.
bool is_reserved(std::string_view folded_word);

}  // namespace animado::interexpserv
