// Text → tokens. Case and accents are folded away here, so everything behind sees lower-case ASCII.
#pragma once

#include <string>
#include <vector>

#include "interexpserv/expression_error.hpp"

namespace animado::interexpserv {

struct Token {
  enum class Kind { number, name, symbol, end };
  Kind kind = Kind::end;
  std::string text;   // folded; empty at the end
  double number = 0;  // of a number
  size_t column = 0;  // 0-based code point

  bool is(std::string_view symbol_or_word) const {
    return kind != Kind::number && kind != Kind::end && text == symbol_or_word;
  }
};

constexpr size_t kMaxTextLength = 20'000;  // code points: some hundred lines of a scene

// The tokens of the text, closed by one of Kind::end. Throws ExpressionError: syntax, limit.
std::vector<Token> tokenize(const Source& source);

}  // namespace animado::interexpserv
