#include "interexpserv/lexer.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/fold.hpp"

namespace animado::interexpserv {
namespace {

constexpr std::array<std::string_view, 17> kSymbols = {"<=", ">=", "==", "!=", "+", "-", "*", "/", "^",
                                                       "<",  ">",  "?",  ":",  "(", ")", ",", "."};

// What people bring from other languages, and how it is said here.
struct Foreign {
  std::string_view symbol, remedy;
};
constexpr std::array<Foreign, 10> kForeign = {{{"**", "write ^ for a power"},
                                               {"&", "write `and`"},
                                               {"|", "write `or`"},
                                               {"!", "write `not`, or != for \"differs from\""},
                                               {"=", "write == to compare"},
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

class Lexer {
 public:
  explicit Lexer(const Source& source) : source_(source), folded_(fold(source.text)) {
    for (size_t i = 0; i < source.text.size(); ++i) {
      if ((static_cast<unsigned char>(source.text[i]) & 0xC0) != 0x80) starts_.push_back(i);
    }
    if (!is_utf8(source.text)) source.refuse(Code::syntax, 0, "the text is not UTF-8");
    if (folded_.size() > kMaxTextLength) {
      throw Error(Code::limit, fmt::format("an expression of {} characters", folded_.size()),
                  std::string(source.where),
                  fmt::format("at most {} are read: define parts of it as names", kMaxTextLength));
    }
  }

  std::vector<Token> run() {
    std::vector<Token> tokens;
    while (true) {
      while (at_ < folded_.size() && is_blank(folded_[at_])) ++at_;
      if (at_ == folded_.size()) break;
      tokens.push_back(next());
    }
    tokens.push_back({Token::Kind::end, {}, 0, at_});
    return tokens;
  }

 private:
  Token next() {
    const char c = folded_[at_];
    const bool number = is_digit(c) || (c == '.' && at_ + 1 < folded_.size() && is_digit(folded_[at_ + 1]));
    if (number) return read_number();
    if (is_letter(c)) return read_name();
    return read_symbol();
  }

  Token read_number() {
    Token token{Token::Kind::number, {}, 0, at_};
    const char* begin = folded_.data() + at_;
    const auto [end, status] = std::from_chars(begin, folded_.data() + folded_.size(), token.number);
    token.text.assign(begin, end);
    if (status == std::errc::result_out_of_range) {
      source_.refuse(Code::syntax, at_, fmt::format("{} does not fit a double", token.text));
    }
    at_ += token.text.size();
    return token;
  }

  Token read_name() {
    const size_t begin = at_;
    while (at_ < folded_.size() && (is_letter(folded_[at_]) || is_digit(folded_[at_]))) ++at_;
    return {Token::Kind::name, folded_.substr(begin, at_ - begin), 0, begin};
  }

  Token read_symbol() {
    const std::string_view rest = std::string_view(folded_).substr(at_);
    const std::string_view written = source_.text.substr(starts_[at_]);
    if (written.starts_with("**")) refuse_character(written);
    for (const std::string_view symbol : kSymbols) {
      // Folding turns unknown characters into '?': only one that was typed is the operator.
      if (!rest.starts_with(symbol) || !written.starts_with(symbol)) continue;
      const Token token{Token::Kind::symbol, std::string(symbol), 0, at_};
      at_ += symbol.size();
      return token;
    }
    refuse_character(written);
  }

  [[noreturn]] void refuse_character(std::string_view written) const {
    for (const auto& [symbol, remedy] : kForeign) {
      if (written.starts_with(symbol)) {
        source_.refuse(Code::syntax, at_, fmt::format("`{}` is no operator here", symbol),
                       std::string(remedy));
      }
    }
    const size_t end = at_ + 1 < starts_.size() ? starts_[at_ + 1] : source_.text.size();
    source_.refuse(Code::syntax, at_,
                   fmt::format("unexpected character `{}`", written.substr(0, end - starts_[at_])),
                   "an expression is made of numbers, names, ( ) , . and + - * / ^ < <= > >= == != ? :");
  }

  const Source& source_;
  std::string folded_;
  std::vector<size_t> starts_;  // byte of source_.text where each code point starts
  size_t at_ = 0;
};

}  // namespace

std::vector<Token> tokenize(const Source& source) {
  return Lexer(source).run();
}

}  // namespace animado::interexpserv
