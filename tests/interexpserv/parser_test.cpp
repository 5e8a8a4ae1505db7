// src/interexpserv/parser.cpp: the order in which things are applied.
#include "interexpserv/parser.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

std::string postfix(std::string_view text) {
  const Source source{text, "test"};
  std::string joined;
  for (const Node& node : parse(source)) {
    if (!joined.empty()) joined += " ";
    if (node.kind == Node::Kind::number) joined += fmt::format("{}", node.number);
    if (node.kind == Node::Kind::name) joined += node.name;
    if (node.kind == Node::Kind::apply) joined += fmt::format("{}/{}", node.name, node.count);
  }
  return joined;
}

TEST(Parser, Precedence) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"a + b*c", "a b c */2 +/2"},
      {"a - b - c", "a b -/2 c -/2"},
      {"a^b^c", "a b c ^/2 ^/2"},
      {"-a^b", "a b ^/2 -/1"},
      {"a^-b*c", "a b -/1 ^/2 c */2"},
      {"-a*b", "a -/1 b */2"},
      {"a*-b^c", "a b c ^/2 -/1 */2"},
      {"not a < b", "a b </2 not/1"},
      {"not a and b", "a not/1 b and/2"},
      {"a or b and c", "a b c and/2 or/2"},
      {"a < b and c > d", "a b </2 c d >/2 and/2"},
      {"a == not b and c", "a b not/1 ==/2 c and/2"},
      {"a ? b : c ? d : e1", "a b c d e1 ?:/3 ?:/3"},
      {"a < b ? c + d : f", "a b </2 c d +/2 f ?:/3"},
      {"(a, b + c, d).y", "a b c +/2 d (,,)/3 .y/1"},
      {"a.b.c + d", "a.b.c d +/2"},
      {"f(a).x^2", "a f/1 .x/1 2 ^/2"},
      {"f(a, g(b), c)", "a b g/1 c f/3"},
      {"90 deg + a", "90 deg/1 a +/2"},
      {"-(a) deg", "a deg/1 -/1"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(postfix(text), expected) << text;
}

TEST(Parser, NodesKnowTheirColumn) {
  const Source source{"é + sin(b)*c", "test"};
  std::vector<size_t> columns;
  for (const Node& node : parse(source)) columns.push_back(node.column);
  EXPECT_EQ(columns, (std::vector<size_t>{0, 8, 4, 11, 10, 2}));
}

TEST(Parser, WordsOfTheLanguageAreReserved) {
  for (const std::string_view word : {"and", "or", "not", "true", "false", "deg", "pi", "e", "t"}) {
    EXPECT_TRUE(is_reserved(word)) << word;
  }
  EXPECT_FALSE(is_reserved("ball"));
  EXPECT_FALSE(is_reserved("sin"));
}

}  // namespace
}  // namespace animado::interexpserv
