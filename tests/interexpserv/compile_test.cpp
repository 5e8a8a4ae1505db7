// src/interexpserv/compile.cpp: what is refused, where the caret stands, what is suggested.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

using testing::HasSubstr;

MapScope example_scope() {
  MapScope scope;
  scope.input("t", Type::scalar)
      .input("ball.position", Type::vector)
      .input("ball.orientation.qw", Type::scalar);
  scope.set("ball.mass", Value::scalar(2)).input("ball.resting", Type::boolean);
  scope.define("a", "b + 1").define("b", "2*c").define("c", "a").define("self", "self");
  scope.define("broken", "1 + bal.mass").define("outer", "3*broken").define("flag", "t > 1");
  return scope;
}

struct CompileError {
  std::string_view text;
  Code code;
  size_t column;
  std::string_view says, remedy;
};

TEST(Compile, RefusesWithPlaceAndRemedy) {
  const CompileError cases[] = {
      // syntax
      {"", Code::syntax, 0, "missing", ""},
      {"   ", Code::syntax, 0, "missing", ""},
      {"1 +", Code::syntax, 3, "found the end", "a value is"},
      {"* 2", Code::syntax, 0, "found `*`", "a value is"},
      {"(1, 2)", Code::syntax, 0, "2 values", "(x, y, z)"},
      {"1 + (1, 2, 3, 4)", Code::syntax, 4, "4 values", "(x, y, z)"},
      {"()", Code::syntax, 1, "found `)`", ""},
      {"(1, 2, 3", Code::syntax, 8, "expected `)`", "column 1 is never closed"},
      {"sin(1", Code::syntax, 5, "expected `)`", "column 1 is never closed"},
      {"sin()", Code::syntax, 4, "found `)`", ""},
      {"1)", Code::syntax, 1, "closes nothing", ""},
      {"2x", Code::syntax, 1, "expected an operator, found `x`", "2 * x"},
      {"2 3", Code::syntax, 2, "expected an operator", "2 * x"},
      {"2(3)", Code::syntax, 1, "expected an operator", "2 * x"},
      {"ball.mass (3)", Code::syntax, 0, "`ball.mass` is a value", "ball.mass * (…)"},
      {"1 < 2 < 3", Code::syntax, 6, "do not chain", "a < b and b < c"},
      {"1 == 2 != 3", Code::syntax, 7, "do not chain", ""},
      {"1 = 2", Code::syntax, 2, "`=`", "=="},
      {"t ** 2", Code::syntax, 2, "`**`", "^"},
      {"true && false", Code::syntax, 5, "`&`", "and"},
      {"true || false", Code::syntax, 5, "`|`", "or"},
      {"!true", Code::syntax, 0, "`!`", "not"},
      {"5 % 3", Code::syntax, 2, "`%`", "mod(a, b)"},
      {"90°", Code::syntax, 2, "`°`", "deg"},
      {"t × 2", Code::syntax, 2, "unexpected character `×`", "made of"},
      {"é × 2", Code::syntax, 2, "unexpected character `×`", ""},
      {"[1, 2, 3]", Code::syntax, 0, "`[`", "(x, y, z)"},
      {"t ? 1", Code::syntax, 5, "expected `:`", ""},
      {"t > 1 ? 1 :", Code::syntax, 11, "found the end", ""},
      {"and 1", Code::syntax, 0, "found `and`", ""},
      {"1 and", Code::syntax, 5, "found the end", ""},
      {"deg", Code::syntax, 0, "found `deg`", ""},
      {"t deg", Code::syntax, 2, "expected an operator", ""},
      {"1e999", Code::syntax, 0, "does not fit", ""},
      {"(1, 2, 3).w", Code::syntax, 10, "component", ".x, .y or .z"},
      {"(1, 2, 3).", Code::syntax, 10, "component", ".x, .y or .z"},
      {"1, 2", Code::syntax, 1, "found `,`", ""},
      {"sin", Code::syntax, 0, "`sin` is a function", "sin(…)"},
      {"t(3)", Code::syntax, 0, "`t` is a value", "t * (…)"},
      {"\xff", Code::syntax, 0, "", ""},
      // types
      {"(1, 2, 3)*(4, 5, 6)", Code::type, 9, "not (vector, vector)", "dot(a, b)"},
      {"1 + (1, 2, 3)", Code::type, 2, "not (scalar, vector)", "three components"},
      {"1/(1, 2, 3)", Code::type, 1, "not (scalar, vector)", "norm(v)"},
      {"(1, 2, 3)^2", Code::type, 9, "not (vector, scalar)", "dot(v, v)"},
      {"abs(ball.position)", Code::type, 0, "not (vector)", "norm(v)"},
      {"norm(3)", Code::type, 0, "not (scalar)", "abs(x)"},
      {"sin((1, 2, 3))", Code::type, 0, "`sin` takes (scalar)", ""},
      {"sin(1, 2)", Code::type, 0, "not (scalar, scalar)", ""},
      {"min(1)", Code::type, 0, "takes (scalar, scalar, …)", ""},
      {"atan2(1)", Code::type, 0, "takes (scalar, scalar)", ""},
      {"clamp(1, 2)", Code::type, 0, "takes (scalar, scalar, scalar)", ""},
      {"1 ? 2 : 3", Code::type, 2, "not (scalar, scalar, scalar)", "x != 0"},
      {"true ? 1 : (1, 2, 3)", Code::type, 5, "not (boolean, scalar, vector)", ""},
      {"1 and 2", Code::type, 2, "takes (boolean, boolean)", ""},
      {"not 1", Code::type, 0, "takes (boolean)", ""},
      {"true + 1", Code::type, 5, "not (boolean, scalar)", ""},
      {"-true", Code::type, 0, "not (boolean)", ""},
      {"(1, 2, 3) < (4, 5, 6)", Code::type, 10, "not (vector, vector)", ""},
      {"(1, (1, 2, 3), 3)", Code::type, 0, "not (scalar, vector, scalar)", ""},
      {"t.y", Code::type, 1, "`.y` takes (vector), not (scalar)", ""},
      {"(1).x", Code::type, 3, "`.x` takes (vector)", ""},
      {"2 * flag", Code::type, 2, "not (scalar, boolean)", ""},
      // names
      {"bal.mass", Code::unknown_name, 0, "unknown name `bal.mass`", "`ball.mass`"},
      {"1 + ball.posicao", Code::unknown_name, 4, "`ball.posicao`", ""},
      {"ball.positon.y", Code::unknown_name, 0, "`ball.positon.y`", "`ball.position`"},
      {"2*sen(t)", Code::unknown_name, 2, "unknown function `sen`", "`sin`"},
      {"zzzzzz", Code::unknown_name, 0, "`zzzzzz`", ""},
      {"ball", Code::unknown_name, 0, "`ball`", ""},
      {"ball.orientation", Code::unknown_name, 0, "`ball.orientation`", "`ball.orientation.qw`"},
      {"ação", Code::unknown_name, 0, "`acao`", ""},
      // definitions
      {"1 + a", Code::cycle, 4, "a → b → c → a", "does not need"},
      {"self", Code::cycle, 0, "self → self", ""},
      {"2*broken", Code::unknown_name, 2, "in the definition of `broken`: unknown name `bal.mass`",
       "`ball.mass`"},
      {"2*outer", Code::unknown_name, 2, "in the definition of `broken`: unknown name `bal.mass`",
       "`ball.mass`"},
  };
  EXPECT_GE(std::size(cases), 40u);
  const MapScope scope = example_scope();
  for (const CompileError& expected : cases) {
    try {
      compile(expected.text, scope, "scene:3:5");
      ADD_FAILURE() << expected.text << " was accepted";
    } catch (const ExpressionError& error) {
      EXPECT_EQ(name_of(error.code()), name_of(expected.code)) << expected.text << "\n" << error.what();
      EXPECT_EQ(error.column(), expected.column) << expected.text << "\n" << error.what();
      EXPECT_THAT(error.message(), HasSubstr(expected.says)) << expected.text;
      EXPECT_THAT(error.remedy(), HasSubstr(expected.remedy)) << expected.text << "\n" << error.what();
      EXPECT_EQ(error.where(), "scene:3:5") << expected.text;
    }
  }
}

TEST(Compile, ShowsTheTextWithACaret) {
  try {
    compile("2 * bal.mass", example_scope(), "scene:7:3");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "scene:7:3: unknown name `bal.mass`\n"
                 "  2 * bal.mass\n"
                 "      ^\n"
                 "  did you mean `ball.mass`?");
  }
}

TEST(Compile, ShowsTheDefinitionThatIsAtFault) {
  try {
    compile("outer", example_scope());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(),
              "in the definition of `broken`: unknown name `bal.mass`\n"
              "  1 + bal.mass\n"
              "      ^");
  }
}

TEST(Compile, AsksForTheTypeThatIsNeeded) {
  const MapScope scope = example_scope();
  EXPECT_EQ(compile("(1, 2, 3)", scope, {}, Type::vector).type(), Type::vector);
  try {
    compile("3", scope, "here", Type::vector);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.code(), Code::type);
    EXPECT_THAT(error.message(), HasSubstr("a vector is needed, this is a scalar"));
    EXPECT_THAT(error.remedy(), HasSubstr("(x, y, z)"));
  }
  EXPECT_THROW(compile("(1, 2, 3)", scope, {}, Type::scalar), ExpressionError);
  EXPECT_THROW(compile("true", scope, {}, Type::scalar), ExpressionError);
}

void expect_limit(const std::string& text, const Scope& scope) {
  try {
    compile(text, scope);
    ADD_FAILURE() << "accepted " << text.substr(0, 40);
  } catch (const Error& error) {
    EXPECT_EQ(name_of(error.code()), "limit") << error.what();
  }
}

std::string repeat(std::string_view part, size_t times) {
  std::string text;
  for (size_t i = 0; i < times; ++i) text += part;
  return text;
}

TEST(Compile, DeepNestingIsALimit) {
  const MapScope scope = example_scope();
  EXPECT_EQ(compile(repeat("(", 190) + "1" + repeat(")", 190), scope).constant(), Value::scalar(1));
  expect_limit(repeat("(", 5000) + "1" + repeat(")", 5000), scope);
  expect_limit(repeat("(", 15000), scope);
  expect_limit(repeat("-", 15000) + "1", scope);
  expect_limit(repeat("not ", 4000) + "true", scope);
  expect_limit(repeat("2^", 5000) + "2", scope);
  expect_limit(repeat("abs(", 4000), scope);
  expect_limit(repeat("true ? 1 : ", 1000) + "2", scope);
}

TEST(Compile, LongTextsAndLongProgramsAreALimit) {
  MapScope scope = example_scope();
  expect_limit(repeat("1+", 10'000) + "1", scope);
  std::string sum = "0";
  for (int i = 0; i < 1500; ++i) sum += fmt::format("+sin(t+{})", i);
  expect_limit(sum, scope);
}

TEST(Compile, ChainsOfDefinitionsAreALimit) {
  MapScope scope;
  scope.define("n0", "1");
  for (int i = 1; i <= 300; ++i) {
    scope.define(fmt::format("n{}", i), fmt::format("n{} + 1", i - 1));
  }
  EXPECT_EQ(compile("n90", scope).constant(), Value::scalar(91));
  expect_limit("n300", scope);
}

// A million definitions of definitions would be written out if each use were compiled again.
TEST(Compile, SharedDefinitionsAreComputedOnce) {
  MapScope scope;
  scope.input("t", Type::scalar).define("a0", "sin(t)");
  for (int i = 1; i <= 20; ++i) {
    scope.define(fmt::format("a{}", i), fmt::format("a{0} + a{0}", i - 1));
  }
  const Program program = compile("a20", scope);
  const double t = 0.5;
  double value = 0;
  program.evaluate(&t, &value);
  EXPECT_DOUBLE_EQ(value, std::sin(0.5) * 1048576);
}

TEST(Compile, LongSumsAreNoNesting) {
  std::string text = "t";
  for (int i = 0; i < 3000; ++i) text += "+t";
  const Program program = compile(text, example_scope());
  const double t = 1;
  double value = 0;
  program.evaluate(&t, &value);
  EXPECT_EQ(value, 3001);
}

}  // namespace
}  // namespace animado::interexpserv
