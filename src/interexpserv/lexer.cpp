#include "interexpserv/lexer.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/fold.hpp"

namespace animado::interexpserv {
namespace {

constexpr std::array<std::string_view, 4> kLongSymbols = {"<=", ">=", "==", "!="};
constexpr std::string_view kSymbols = "+-*/^<>?:(),.";

// What people bring from other languages, and how it is said here.
struct Foreign {
  std::string_view symbol, remedy;
};
constexpr std::array<Foreign, 10> kForeign = {{{"**", "write ^ for a power"},
                                               {"&", "write `and`"},
                                               {"|", "write `or`"},
                                               {"!", "write `not`, or != for \"differs from\""},
                                               {"=", "write == to compare; a function is f(x) = …"},
                                               {"%", "write mod(a, b)"},
                                               {"[", "write a vector as (x, y, z), a component as v.x"},
                                               {"{", "write parentheses"},
                                               {";", "an expression is one value: leave it out"},
                                               {"°", "write 90 deg"}}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || c == '_';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// Whether every code point has as many continuation bytes as its first byte says.
bool is_utf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const size_t length = lead < 0x80   ? 1
                          : lead < 0xC0 ? 0
                          : lead < 0xE0 ? 2
                          : lead < 0xF0 ? 3
                          : lead < 0xF8 ? 4
                                        : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

// Whether the tokens are "(x, y)": what may stand before the `=` of a function.
bool are_parameters(const std::vector<Token>& tokens) {
  if (tokens.size() < 3 || !tokens.front().is("(") || !tokens.back().is(")")) return false;
  for (size_t i = 1; i + 1 < tokens.size(); ++i) {
    if (i % 2 == 1 ? tokens[i].kind != Token::Kind::name : !tokens[i].is(",")) return false;
  }
  return tokens.size() % 2 == 1;
}

class Lexer {
 public:
  explicit Lexer(const Source& source)
      : source_(source), text_(std::make_unique<const std::string>(fold(source.text))), folded_(*text_) {
    if (folded_.size() != source.text.size()) {
      for (size_t i = 0; i < source.text.size(); ++i) {
        if ((static_cast<unsigned char>(source.text[i]) & 0xC0) != 0x80) starts_.push_back(i);
      }
      if (!is_utf8(source.text)) source.refuse(Code::syntax, 0, "the text is not UTF-8");
    } else if (!is_utf8(source.text)) {
      source.refuse(Code::syntax, 0, "the text is not UTF-8");
    }
    if (folded_.size() > kMaxTextLength) {
      throw Error(Code::limit, fmt::format("an expression of {} characters", folded_.size()),
                  std::string(source.where),
                  fmt::format("at most {} are read: define parts of it as names", kMaxTextLength));
    }
  }

  Tokens run() && {
    tokens_.reserve(folded_.size() / 2 + 2);
    while (true) {
      while (at_ < folded_.size() && is_blank(folded_[at_])) ++at_;
      if (at_ == folded_.size()) break;
      tokens_.push_back(next());
    }
    tokens_.push_back({Token::Kind::end, {}, {}, 0, at_});
    return {std::move(text_), std::move(tokens_)};
  }

 private:
  Token next() {
    const char c = folded_[at_];
    const bool number = is_digit(c) || (c == '.' && at_ + 1 < folded_.size() && is_digit(folded_[at_ + 1]));
    if (number) return read_number();
    if (is_letter(c)) return read_name();
    return c == '"' ? read_text() : read_symbol();
  }

  // The byte of the source where a code point starts.
  size_t start(size_t at) const {
    return starts_.empty() ? at : at < starts_.size() ? starts_[at] : source_.text.size();
  }

  Token token(Token::Kind kind, size_t length) {
    const size_t begin = at_;
    at_ += length;
    return {kind, folded_.substr(begin, length), source_.text.substr(start(begin), start(at_) - start(begin)),
            0, begin};
  }

  Token read_number() {
    double number = 0;
    const char* begin = folded_.data() + at_;
    const auto [end, status] = std::from_chars(begin, folded_.data() + folded_.size(), number);
    const auto length = static_cast<size_t>(end - begin);
    if (status == std::errc::result_out_of_range) {
      source_.refuse(Code::syntax, at_, fmt::format("{} does not fit a double", folded_.substr(at_, length)));
    }
    Token read = token(Token::Kind::number, length);
    read.number = number;
    return read;
  }

  Token read_name() {
    size_t end = at_;
    while (end < folded_.size() && (is_letter(folded_[end]) || is_digit(folded_[end]))) ++end;
    return token(Token::Kind::name, end - at_);
  }

  Token read_text() {
    const size_t close = folded_.find('"', at_ + 1);
    if (close == std::string_view::npos) {
      source_.refuse(Code::syntax, at_, "a text that is never closed", "write a \" behind it");
    }
    Token read = token(Token::Kind::text, close + 1 - at_);
    read.text = read.written.substr(1, read.written.size() - 2);
    return read;
  }

  Token read_symbol() {
    const std::string_view rest = folded_.substr(at_), written = source_.text.substr(start(at_));
    if (written.starts_with("**")) refuse_character(written);
    for (const std::string_view symbol : kLongSymbols) {
      if (rest.starts_with(symbol)) return token(Token::Kind::symbol, 2);
    }
    // Folding turns unknown characters into '?': only one that was typed is the operator.
    const bool known = rest[0] == written[0] && kSymbols.find(rest[0]) != std::string_view::npos;
    if (known || (rest[0] == '=' && are_parameters(tokens_))) return token(Token::Kind::symbol, 1);
    refuse_character(written);
  }

  [[noreturn]] void refuse_character(std::string_view written) const {
    for (const auto& [symbol, remedy] : kForeign) {
      if (written.starts_with(symbol)) {
        source_.refuse(Code::syntax, at_, fmt::format("`{}` is no operator here", symbol),
                       std::string(remedy));
      }
    }
    source_.refuse(Code::syntax, at_,
                   fmt::format("unexpected character `{}`", written.substr(0, start(at_ + 1) - start(at_))),
                   "an expression is made of numbers, names, ( ) , . and + - * / ^ < <= > >= == != ? :");
  }

  const Source& source_;
  std::unique_ptr<const std::string> text_;
  std::string_view folded_;
  std::vector<size_t> starts_;  // byte of source_.text where each code point starts; none where all are bytes
  std::vector<Token> tokens_;
  size_t at_ = 0;
};

}  // namespace

Tokens tokenize(const Source& source) {
  return Lexer(source).run();
}

}  // namespace animado::interexpserv
