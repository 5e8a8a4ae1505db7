// src/interexpserv/lexer.cpp
#include "interexpserv/lexer.hpp"

#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

std::vector<Token> tokens_of(std::string_view text) {
  const Source source{text, "test"};
  return tokenize(source);
}

std::string words(std::string_view text) {
  std::string joined;
  for (const Token& token : tokens_of(text)) joined += token.text + "|";
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
    const Token token = tokens_of(text).front();
    EXPECT_EQ(token.kind, Token::Kind::number) << text;
    EXPECT_EQ(token.number, value) << text;
  }
}

TEST(Lexer, FoldsCaseAndAccentsAndKeepsColumns) {
  const std::vector<Token> tokens = tokens_of("Fricção + POSIÇÃO");
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

TEST(Lexer, EverySingleByteIsReadOrRefused) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text(1, static_cast<char>(byte));
    try {
      EXPECT_LE(tokens_of(text).size(), 2u);
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.code(), Code::syntax);
    }
  }
}

}  // namespace
}  // namespace animado::interexpserv
