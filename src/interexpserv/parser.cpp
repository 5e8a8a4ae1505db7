#include "interexpserv/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/nearest_name.hpp"

namespace animado::interexpserv {
namespace {

//   expression = operation [ "?" expression ":" expression ]
//   operation  = prefix operation | postfix { binary operation }      by the bindings below
//   prefix     = "-" | "+" | "not"
//   postfix    = primary { "." component } | ( number | "(" … ")" ) [ unit ] { "." component }
//   primary    = number | name { "." name } [ "(" list ")" ] | "(" expression ")" | "(" x "," y "," z ")"
//   list       = expression { "," expression }
//   unit       = word { ( "*" | "/" ) word | "^" integer }            without blanks: 9.81 m/s^2
//
// A whole text may also be a function's:  "(" name { "," name } ")" "=" expression
//
// An operator takes its left operand when its `left` exceeds what stands before it, and hands `right` to its
// own right operand: left > right groups to the right. -2^2 is -(2^2), 2^-1 is 1/2, not a < b is not (a < b).
struct Binary {
  std::string_view symbol;
  int left, right;
};
constexpr std::array<Binary, 13> kBinary = {{{"or", 1, 1},
                                             {"and", 2, 2},
                                             {"==", 4, 4},
                                             {"!=", 4, 4},
                                             {"<", 4, 4},
                                             {"<=", 4, 4},
                                             {">", 4, 4},
                                             {">=", 4, 4},
                                             {"+", 5, 5},
                                             {"-", 5, 5},
                                             {"*", 6, 6},
                                             {"/", 6, 6},
                                             {"^", 9, 8}}};
constexpr int kComparison = 4, kNot = 3, kSign = 7;

const Binary* find_binary(const Token& token) {
  if (token.kind != Token::Kind::symbol && token.kind != Token::Kind::name) return nullptr;
  for (const Binary& binary : kBinary) {
    if (token.is(binary.symbol)) return &binary;
  }
  return nullptr;
}

class Parser {
 public:
  explicit Parser(const Source& source) : source_(source) {
    result_.tokens = tokenize(source);
    nodes_.reserve(tokens_.size());
  }

  Expression run() && {
    if (now().kind == Token::Kind::end) source_.refuse(Code::syntax, 0, "an expression is missing");
    parameters();
    expression();
    if (now().kind != Token::Kind::end) refuse_leftover();
    return std::move(result_);
  }

 private:
  // One level of nesting for as long as it lives.
  struct Level {
    explicit Level(Parser& parser) : depth(parser.depth_) {
      if (++depth > kMaxNesting) {
        parser.source_.refuse(Code::limit, parser.now().column,
                              fmt::format("nested more than {} deep", kMaxNesting),
                              "define parts of it as names");
      }
    }
    ~Level() { --depth; }
    int& depth;
  };

  // The lexer lets an `=` pass behind "(x, y)" alone.
  void parameters() {
    const auto equals =
        std::find_if(tokens_.begin(), tokens_.end(), [](const Token& t) { return t.is("="); });
    if (equals == tokens_.end()) return;
    auto& names = result_.parameters;
    while (!now().is("=")) {
      const Token token = take();
      if (token.kind != Token::Kind::name) continue;
      if (is_reserved(token.text) && token.text != "t") {
        source_.refuse(Code::syntax, token.column, fmt::format("`{}` is a word of the language", token.text),
                       "choose another name for the parameter");
      }
      if (std::find(names.begin(), names.end(), token.text) != names.end()) {
        source_.refuse(Code::syntax, token.column, fmt::format("two parameters `{}`", token.text),
                       "give each a name of its own");
      }
      names.push_back(token.text);
    }
    if (names.size() > kMaxParameters) {
      source_.refuse(Code::limit, 0, fmt::format("{} parameters", names.size()),
                     fmt::format("a function has at most {}", kMaxParameters));
    }
    take();
  }

  void expression() {
    const Level level(*this);
    operation(0);
    if (!now().is("?")) return;
    const size_t column = take().column;
    expression();
    expect(":", "the other value of `condition ? a : b`");
    expression();
    apply("?:", 3, column);
  }

  void nested_operation(int limit) {
    const Level level(*this);
    operation(limit);
  }

  void operation(int limit) {
    if (now().is("not") || now().is("-") || now().is("+")) {
      const Token prefix = take();
      nested_operation(prefix.is("not") ? kNot : kSign);
      apply(prefix.text, 1, prefix.column);
    } else {
      postfix();
    }
    for (const Binary* binary = find_binary(now()); binary && binary->left > limit;
         binary = find_binary(now())) {
      const size_t column = take().column;
      nested_operation(binary->right);
      apply(binary->symbol, 2, column);
      if (binary->left == kComparison) refuse_chain();
    }
  }

  void postfix() {
    const bool may_have_unit = now().kind == Token::Kind::number || now().is("(");
    primary();
    if (may_have_unit) unit();
    while (now().is(".")) {
      const size_t column = take().column;
      const Token component = take();
      std::string_view name;
      for (const std::string_view known : {".x", ".y", ".z"}) {
        if (component.is(known.substr(1))) name = known;
      }
      if (name.empty()) {
        source_.refuse(Code::syntax, component.column, "expected a component after the dot",
                       "write .x, .y or .z");
      }
      apply(name, 1, column);
    }
  }

  // What stands behind a number: 10 cm, 9.81 m/s^2. Without blanks inside, so that 10 m / h divides by a
  // name.
  void unit() {
    if (now().kind != Token::Kind::name || find_binary(now())) return;
    const Unit* first = find_unit(now().written);
    if (!first) return;
    const Token begin = take();
    WrittenUnit unit;
    multiply(unit, *first, exponent());
    while (now().is("*") || now().is("/")) {
      const Token& word = after();
      const Token& behind = tokens_[std::min(at_ + 2, tokens_.size() - 1)];
      const Unit* next = word.kind == Token::Kind::name ? find_unit(word.written) : nullptr;
      const bool joined = touches(now(), before()) && touches(word, now());
      if (!next || !joined || behind.is("(") || behind.is(".")) break;
      const bool divides = take().is("/");
      unit.further.push_back(take());
      multiply(unit, *next, divides ? -exponent() : exponent());
    }
    nodes_.push_back({Node::Kind::unit, begin.text, 0, static_cast<int>(result_.units.size()), begin.column});
    result_.units.push_back(std::move(unit));
  }

  static void multiply(WrittenUnit& to, const Unit& unit, int exponent) {
    for (int k = 0; k < std::abs(exponent); ++k) {
      to.factor *= exponent > 0 ? unit.factor : unit.divisor;
      to.divisor *= exponent > 0 ? unit.divisor : unit.factor;
    }
    to.dimension = to.dimension * to_power(unit.dimension, exponent);
  }

  int exponent() {
    if (!now().is("^") || !touches(now(), before())) return 1;
    const bool minus = after().is("-");
    const Token& number = tokens_[std::min(at_ + (minus ? 2 : 1), tokens_.size() - 1)];
    const bool whole = number.kind == Token::Kind::number && number.number <= 6 &&
                       number.number == static_cast<int>(number.number);
    if (!whole) {
      source_.refuse(Code::syntax, after().column, "a unit has a whole number of at most 6 for exponent",
                     "write m^2, s^-1; put (…) around a value that is to be raised");
    }
    take();
    if (minus) take();
    take();
    return minus ? -static_cast<int>(number.number) : static_cast<int>(number.number);
  }

  static bool touches(const Token& token, const Token& previous) { return token.column == previous.end(); }

  void primary() {
    const Token token = take();
    if (token.kind == Token::Kind::number) {
      nodes_.push_back({Node::Kind::number, {}, token.number, 0, token.column});
    } else if (token.kind == Token::Kind::text) {
      nodes_.push_back({Node::Kind::text, token.text, 0, 0, token.column});
    } else if (token.is("(")) {
      parenthesis(token.column);
    } else if (token.kind == Token::Kind::name && !find_binary(token) && !token.is("not") &&
               !token.is("deg")) {
      name_or_call(token);
    } else {
      source_.refuse(Code::syntax, token.column, "expected a value, found " + shown(token),
                     "a value is a number, a name, a call like sin(x), or something in parentheses");
    }
  }

  static std::string shown(const Token& token) {
    return token.kind == Token::Kind::end ? "the end" : fmt::format("`{}`", token.text);
  }

  void parenthesis(size_t column) {
    const int count = list(column);
    if (count == 1) return;
    if (count != 3) {
      source_.refuse(Code::syntax, column, fmt::format("{} values in parentheses", count),
                     "a vector has three: (x, y, z)");
    }
    apply("(,,)", 3, column);
  }

  // Values up to the closing parenthesis, which is taken too. How many there are.
  int list(size_t opened_at) {
    int count = 0;
    do {
      // The word of table("…", t, cubic) is no name.
      const bool word = now().is("cubic") || now().is("linear");
      if (word && after().is(")")) {
        const Token token = take();
        nodes_.push_back({Node::Kind::text, token.text, 0, 0, token.column});
      } else {
        expression();
      }
      ++count;
    } while (take_if(","));
    if (!now().is(")")) {
      const bool end = now().kind == Token::Kind::end;
      if (!end) refuse_leftover();
      source_.refuse(Code::syntax, now().column, "expected `)`, found the end",
                     fmt::format("the parenthesis in column {} is never closed", opened_at + 1));
    }
    take();
    return count;
  }

  void name_or_call(const Token& first) {
    std::string_view path = first.text;
    size_t end = first.end();
    while (now().is(".") && after().kind == Token::Kind::name) {
      const bool joined = touches(now(), before()) && touches(after(), now());
      take();
      const Token part = take();
      if (joined && end == first.column + path.size()) {
        path = std::string_view(*result_.tokens.folded).substr(first.column, part.end() - first.column);
      } else {
        path = result_.spaced.emplace_front(fmt::format("{}.{}", path, part.text));
      }
      end = part.end();
    }
    if (!now().is("(")) {
      nodes_.push_back({Node::Kind::name, path, 0, 0, first.column});
      return;
    }
    take();
    apply(path, list(first.column), first.column);
  }

  void apply(std::string_view function, int count, size_t column) {
    nodes_.push_back({Node::Kind::apply, function, 0, count, column});
  }

  void refuse_chain() const {
    const Binary* next = find_binary(now());
    if (next && next->left == kComparison) {
      source_.refuse(Code::syntax, now().column, "comparisons do not chain", "write a < b and b < c");
    }
  }

  [[noreturn]] void refuse_leftover() const {
    const Token& token = now();
    if (token.is(")")) {
      source_.refuse(Code::syntax, token.column, "a `)` that closes nothing",
                     "take it away, or open a ( before");
    }
    const bool value = token.kind != Token::Kind::symbol || token.is("(");
    source_.refuse(Code::syntax, token.column, fmt::format("expected an operator, found `{}`", token.text),
                   value ? remedy_of_product(token) : "");
  }

  std::string remedy_of_product(const Token& token) const {
    const bool after_number = at_ > 0 && before().kind == Token::Kind::number;
    const std::vector<std::string> units = known_units();
    const std::string near = after_number && token.text.size() > 1 ? nearest_name(token.written, units) : "";
    return near.empty()
               ? "a product needs its sign: write 2 * x"
               : fmt::format("a product needs its sign: write 2 * x; if a unit is meant: `{}`?", near);
  }

  const Token& now() const { return tokens_[at_]; }
  const Token& before() const { return tokens_[at_ - 1]; }
  const Token& after() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  Token take() { return at_ + 1 < tokens_.size() ? tokens_[at_++] : tokens_[at_]; }
  bool take_if(std::string_view symbol) {
    const bool there = now().is(symbol);
    if (there) take();
    return there;
  }
  void expect(std::string_view symbol, std::string_view what) {
    if (take_if(symbol)) return;
    source_.refuse(Code::syntax, now().column, fmt::format("expected `{}` and {}", symbol, what));
  }

  const Source& source_;
  Expression result_;
  const std::vector<Token>& tokens_ = result_.tokens.list;
  std::vector<Node>& nodes_ = result_.nodes;
  size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse(const Source& source) {
  return Parser(source).run();
}

bool is_function_text(std::string_view text) {
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals + 1 == text.size() || text[equals + 1] == '=') return false;
  const size_t close = text.find(')'), open = text.find_first_not_of(" \t");
  return open != std::string_view::npos && text[open] == '(' && close < equals &&
         text.find_first_not_of(" \t", close + 1) == equals;
}

bool is_reserved(std::string_view word) {
  constexpr std::array<std::string_view, 9> kWords = {"and", "or", "not", "true", "false",
                                                      "deg", "pi", "e",   "t"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

}  // namespace animado::interexpserv
