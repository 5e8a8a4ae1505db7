#include "interexpserv/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "interexpserv/lexer.hpp"

namespace animado::interexpserv {
namespace {

//   expression = operation [ "?" expression ":" expression ]
//   operation  = prefix operation | postfix { binary operation }      by the bindings below
//   prefix     = "-" | "+" | "not"
//   postfix    = primary { "." component | "deg" }                    deg after a number or a parenthesis
//   primary    = number | name { "." name } | name "(" list ")" | "(" expression ")" | "(" x "," y "," z ")"
//   list       = expression { "," expression }
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
  for (const Binary& binary : kBinary) {
    if (token.is(binary.symbol)) return &binary;
  }
  return nullptr;
}

class Parser {
 public:
  explicit Parser(const Source& source) : source_(source), tokens_(tokenize(source)) {}

  std::vector<Node> run() {
    if (now().kind == Token::Kind::end) source_.refuse(Code::syntax, 0, "an expression is missing");
    expression();
    if (now().kind != Token::Kind::end) refuse_leftover();
    return std::move(nodes_);
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
      apply(std::string(binary->symbol), 2, column);
      if (binary->left == kComparison) refuse_chain();
    }
  }

  void postfix() {
    const bool angle = now().kind == Token::Kind::number || now().is("(");
    primary();
    if (angle && now().is("deg")) apply("deg", 1, take().column);
    while (now().is(".")) {
      const size_t column = take().column;
      const Token component = take();
      if (!component.is("x") && !component.is("y") && !component.is("z")) {
        source_.refuse(Code::syntax, component.column, "expected a component after the dot",
                       "write .x, .y or .z");
      }
      apply("." + component.text, 1, column);
    }
  }

  void primary() {
    const Token token = take();
    if (token.kind == Token::Kind::number) {
      nodes_.push_back({Node::Kind::number, {}, token.number, 0, token.column});
    } else if (token.is("(")) {
      parenthesis(token.column);
    } else if (token.kind == Token::Kind::name && now().is("(") && !find_binary(token)) {
      take();
      apply(token.text, list(token.column), token.column);
    } else if (token.kind == Token::Kind::name && !find_binary(token) && !token.is("not") &&
               !token.is("deg")) {
      name(token);
    } else {
      const std::string found = token.kind == Token::Kind::end ? "the end" : "`" + token.text + "`";
      source_.refuse(Code::syntax, token.column, "expected a value, found " + found,
                     "a value is a number, a name, a call like sin(x), or something in parentheses");
    }
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
      expression();
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

  void name(const Token& first) {
    std::string path = first.text;
    while (now().is(".") && after().kind == Token::Kind::name) {
      take();
      path.append(1, '.').append(take().text);
    }
    nodes_.push_back({Node::Kind::name, std::move(path), 0, 0, first.column});
  }

  void apply(std::string function, int count, size_t column) {
    nodes_.push_back({Node::Kind::apply, std::move(function), 0, count, column});
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
    const bool value = token.kind == Token::Kind::number || token.kind == Token::Kind::name || token.is("(");
    source_.refuse(Code::syntax, token.column, fmt::format("expected an operator, found `{}`", token.text),
                   value ? "a product needs its sign: write 2 * x" : "");
  }

  const Token& now() const { return tokens_[at_]; }
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
  std::vector<Token> tokens_;
  std::vector<Node> nodes_;
  size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::vector<Node> parse(const Source& source) {
  return Parser(source).run();
}

bool is_reserved(std::string_view word) {
  constexpr std::array<std::string_view, 9> kWords = {"and", "or", "not", "true", "false",
                                                      "deg", "pi", "e",   "t"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

}  // namespace animado::interexpserv
