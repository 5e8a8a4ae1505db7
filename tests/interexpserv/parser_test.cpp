// src/interexpserv/parser.cpp: the order in which things are applied.
#include "interexpserv/parser.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

std::string postfix(std::string_view text) {
  const Source source{text, "test"};
  std::string joined;
  const Expression parsed = parse(source);
  for (const Node& node : parsed) {
    if (!joined.empty()) joined += " ";
    if (node.kind == Node::Kind::number) joined += fmt::format("{}", node.number);
    if (node.kind == Node::Kind::name) joined += node.name;
    if (node.kind == Node::Kind::text) joined += fmt::format("\"{}\"", node.name);
    if (node.kind == Node::Kind::unit) {
      const WrittenUnit& unit = parsed.units[static_cast<size_t>(node.count)];
      joined += fmt::format("[{:g}/{:g} {}]", unit.factor, unit.divisor, text_of(unit.dimension));
    }
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
      {"90 rad + a", "90 [1/1 a number or an angle] a +/2"},
      {"-(a) rad", "a [1/1 a number or an angle] -/1"},
      {"9.81 m/s^2", "9.81 [1/1 an acceleration (m s^-2)]"},
      {"10 m / s", "10 [1/1 a length (m)] s //2"},
      {"10 m/k", "10 [1/1 a length (m)] k //2"},
      {"2 kg*s.mass", "2 [1/1 a mass (kg)] s.mass */2"},
      {"2 kg*m^2/s", "2 [1/1 kg m^2 s^-1]"},
      {"90 km/h", "90 [1000/3600 a velocity (m s^-1)]"},
      {"3 s^-1", "3 [1/1 a rate (s^-1)]"},
      {"(3 m)^2", "3 [1/1 a length (m)] 2 ^/2"},
      {"5 MN - 5 mN", "5 [1e+06/1 a force (kg m s^-2)] 5 [1/1000 a force (kg m s^-2)] -/2"},
      {"ball . position . y", "ball.position.y"},
      {"spring . f (2)", "2 spring.f/1"},
      {"table(\"Wind.csv\", t, cubic)", "\"Wind.csv\" t \"cubic\" table/3"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(postfix(text), expected) << text;
}

TEST(Parser, NodesKnowTheirColumn) {
  const Source source{"é + sin(b)*c", "test"};
  std::vector<size_t> columns;
  const Expression parsed = parse(source);
  for (const Node& node : parsed) columns.push_back(node.column);
  EXPECT_EQ(columns, (std::vector<size_t>{0, 8, 4, 11, 10, 2}));
}

TEST(Parser, AFunctionHasParameters) {
  const Source source{"(x, y) = x^2 + y", "test"};
  const Expression parsed = parse(source);
  EXPECT_EQ(parsed.parameters, (std::vector<std::string_view>{"x", "y"}));
  EXPECT_EQ(parsed.nodes.size(), 5u);
  EXPECT_TRUE(is_function_text(" (x) = x"));
  for (const std::string_view text :
       {"", "(x)", "(x) == x", "x = 2", "(x <= 2)", "f(x) = 2", "(x) + (y) = 2"}) {
    EXPECT_FALSE(is_function_text(text)) << text;
  }
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
