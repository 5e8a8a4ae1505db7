// Text → tokens. Case and accents are folded away here, so everything behind sees lower-case ASCII.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "interexpserv/expression_error.hpp"

namespace animado::interexpserv {

struct Token {
  enum class Kind { number, name, symbol, text, end };
  Kind kind = Kind::end;
  std::string_view text;     // folded; what stands between the quotes of a text; empty at the end
  std::string_view written;  // as it stands in the source
  double number = 0;         // of a number
  size_t column = 0;         // 0-based code point

  bool is(std::string_view symbol_or_word) const {
    return (kind == Kind::name || kind == Kind::symbol) && text == symbol_or_word;
  }
  size_t end() const { return column + text.size(); }  // of a number, name or symbol
};

struct Tokens {
  std::unique_ptr<const std::string> folded;  // what their texts are parts of
  std::vector<Token> list;                    // closed by one of Kind::end
};

constexpr size_t kMaxTextLength = 20'000;  // code points: some hundred lines of a scene

// Throws ExpressionError: syntax, limit.
Tokens tokenize(const Source& source);

}  // namespace animado::interexpserv
