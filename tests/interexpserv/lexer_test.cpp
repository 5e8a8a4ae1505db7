// src/interexpserv/lexer.cpp
#include "interexpserv/lexer.hpp"

#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

Tokens tokens_of(std::string_view text) {
  const Source source{text, "test"};
  return tokenize(source);
}

std::string words(std::string_view text) {
  std::string joined;
  const Tokens tokens = tokens_of(text);
  for (const Token& token : tokens.list) joined.append(token.text).append("|");
  return joined;
}

TEST(Lexer, CutsNumbersNamesAndSymbols) {
  EXPECT_EQ(words("ball.position.y<=1e-3*(2-.5)"), "ball|.|position|.|y|<=|1e-3|*|(|2|-|.5|)||");
  EXPECT_EQ(words("a==b!=c>=d"), "a|==|b|!=|c|>=|d||");
  EXPECT_EQ(words("1.x"), "1.|x||");
  EXPECT_EQ(words("1e"), "1|e||");
  EXPECT_EQ(words(""), "|");
}

TEST(Lexer, NumbersHaveTheirValue) {
  for (const auto& [text, value] : std::vector<std::pair<std::string_view, double>>{
           {"0.", 0.0}, {".7", 0.7}, {"12", 12}, {"1e-3", 1e-3}, {"1E+3", 1e3}, {"007", 7}, {"2.5", 2.5}}) {
    const Token token = tokens_of(text).list.front();
    EXPECT_EQ(token.kind, Token::Kind::number) << text;
    EXPECT_EQ(token.number, value) << text;
  }
}

TEST(Lexer, FoldsCaseAndAccentsAndKeepsColumns) {
  const Tokens read = tokens_of("Fricção + POSIÇÃO");
  const std::vector<Token>& tokens = read.list;
  EXPECT_EQ(tokens[0].text, "friccao");
  EXPECT_EQ(tokens[1].column, 8u);
  EXPECT_EQ(tokens[2].text, "posicao");
  EXPECT_EQ(tokens[2].column, 10u);
  EXPECT_EQ(tokens[3].column, 17u);
}

TEST(Lexer, AForeignCharacterIsNoQuestionMark) {
  EXPECT_EQ(words("a ? b : c"), "a|?|b|:|c||");
  for (const std::string_view text : {"a × b", "a \xff", "a \xc3", "\xe2\x82", "a 中 b", "a\x01"}) {
    EXPECT_THROW(tokens_of(text), ExpressionError) << text;
  }
}

TEST(Lexer, TextsKeepTheirCase) {
  const Tokens read = tokens_of("table(\"Ação #1.csv\", t)");
  EXPECT_EQ(read.list[2].kind, Token::Kind::text);
  EXPECT_EQ(read.list[2].text, "Ação #1.csv");
  EXPECT_EQ(read.list[4].column, 21u);
  EXPECT_THROW(tokens_of("\"open"), ExpressionError);
}

TEST(Lexer, AnEqualSignStandsBehindParametersAlone) {
  EXPECT_EQ(words("(x, y) = x"), "(|x|,|y|)|=|x||");
  for (const std::string_view text : {"x = 1", "(1) = 2", "(x y) = 2", "(x,) = 2", "() = 2", "2*(x) = 2"}) {
    EXPECT_THROW(tokens_of(text), ExpressionError) << text;
  }
}

TEST(Lexer, EverySingleByteIsReadOrRefused) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text(1, static_cast<char>(byte));
    try {
      EXPECT_LE(tokens_of(text).list.size(), 2u);
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.code(), Code::syntax);
    }
  }
}

}  // namespace
}  // namespace animado::interexpserv
