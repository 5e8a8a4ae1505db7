// src/interexpserv/program.cpp: what expressions are worth.
#include "interexpserv/program.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace animado::interexpserv {
namespace {

constexpr double kPi = std::numbers::pi, kE = std::numbers::e;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// t = 2, k = 3, ball.position = (1, 2, 3), ball.mass = 2, ball.weight = (0, -9.81*mass, 0) inside ball.
MapScope example_scope() {
  MapScope scope;
  scope.input("t", Type::scalar).input("k", Type::scalar).input("ball.position", Type::vector);
  scope.input("ball.orientation.qw", Type::scalar).input("ball.resting", Type::boolean);
  scope.set("ball.mass", Value::scalar(2)).define("ball.weight", "(0, -9.81*mass, 0)", "ball");
  scope.define("spring.k", "4*pi^2*ball.mass").define("pull", "-spring.k*ball.position");
  return scope;
}

std::vector<double> example_inputs(const Program& program) {
  const std::map<std::string, std::vector<double>> values = {{"t", {2}},
                                                             {"k", {3}},
                                                             {"ball.position", {1, 2, 3}},
                                                             {"ball.orientation.qw", {0.5}},
                                                             {"ball.resting", {1}}};
  std::vector<double> inputs;
  for (const Input& input : program.inputs()) {
    const std::vector<double>& value = values.at(input.name);
    inputs.insert(inputs.end(), value.begin(), value.end());
  }
  return inputs;
}

Value worth(std::string_view text) {
  const MapScope scope = example_scope();
  const Program program = compile(text, scope, "test");
  const std::vector<double> inputs = example_inputs(program);
  EXPECT_EQ(inputs.size(), program.input_count()) << text;
  Value value{program.type(), {}};
  program.evaluate(inputs.data(), value.v.data());
  return value;
}

// Equal to the last bit where arithmetic is exact; two units in the last place where the expected value was
// itself rounded in another order.
void expect_number(double found, double expected, std::string_view text) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(found)) << text << " is " << found;
  } else {
    EXPECT_DOUBLE_EQ(found, expected) << text;
  }
}

struct ScalarCase {
  std::string_view text;
  double value;
};

TEST(Program, Scalars) {
  const ScalarCase cases[] = {
      // numbers
      {"0", 0},
      {"0.", 0},
      {".7", 0.7},
      {"1e-3", 1e-3},
      {"1E3", 1000},
      {"2.5e+2", 250},
      {"  7  ", 7},
      {"1.e2", 100},
      {"9007199254740993", 9007199254740992.0},
      {"4.9e-324", 4.9e-324},
      {"0.1", 0.1},
      {"1\n+\t1", 2},
      // sums, products, signs
      {"1+2", 3},
      {"1-2-3", -4},
      {"1-(2-3)", 2},
      {"2*3+4", 10},
      {"2+3*4", 14},
      {"(2+3)*4", 20},
      {"7/2", 3.5},
      {"8/4/2", 1},
      {"8/4*2", 4},
      {"-3", -3},
      {"--3", 3},
      {"+3", 3},
      {"-+-3", 3},
      {"2*-3", -6},
      {"2--3", 5},
      {"-2*-3", 6},
      {"((((1))))", 1},
      {"1/4+1/4", 0.5},
      // powers
      {"2^3", 8},
      {"2^3^2", 512},
      {"(2^3)^2", 64},
      {"-2^2", -4},
      {"(-2)^2", 4},
      {"2^-1", 0.5},
      {"2^-2^2", 1.0 / 16},
      {"-2^-2", -0.25},
      {"2*3^2", 18},
      {"4^0.5", 2},
      {"(-8)^3", -512},
      {"0^0", 1},
      {"2^0.5^2", std::pow(2, 0.25)},
      {"3^2*2", 18},
      {"k^2", 9},
      {"k^3", 27},
      {"-k^2", -9},
      {"2^-1*3", 1.5},
      // degrees
      {"90 deg", kPi / 2},
      {"180deg", kPi},
      {"-45 deg", -kPi / 4},
      {"(30+60) deg", kPi / 2},
      {"2*90 deg", kPi},
      {"360 DEG", 2 * kPi},
      {"sin(30 deg)", 0.5},
      // constants and names
      {"pi", kPi},
      {"e", kE},
      {"PI", kPi},
      {"t", 2},
      {"T", 2},
      {"2*t+k", 7},
      {"ball.mass", 2},
      {"Ball.Mass", 2},
      {"ball.position.x", 1},
      {"ball.position.y", 2},
      {"BALL.POSITION.Z", 3},
      {"ball . position . y", 2},
      {"ball.orientation.qw", 0.5},
      {"spring.k", 8 * kPi * kPi},
      {"ball.weight.y", -19.62},
      {"spring.k/ball.mass", 4 * kPi * kPi},
      {"báll.pôsition.y", 2},
      // functions
      {"sin(0)", 0},
      {"sin(pi/2)", 1},
      {"cos(0)", 1},
      {"cos(pi)", -1},
      {"tan(pi/4)", std::tan(kPi / 4)},
      {"asin(1)", kPi / 2},
      {"acos(-1)", kPi},
      {"acos(1)", 0},
      {"atan(1)", kPi / 4},
      {"atan2(1, 1)", kPi / 4},
      {"atan2(1, -1)", 3 * kPi / 4},
      {"atan2(-1, 0)", -kPi / 2},
      {"sinh(1)", (kE - 1 / kE) / 2},
      {"cosh(0)", 1},
      {"tanh(0)", 0},
      {"tanh(1000)", 1},
      {"exp(0)", 1},
      {"exp(1)", kE},
      {"log(e)", 1},
      {"log(1)", 0},
      {"log10(1000)", 3},
      {"sqrt(2)", std::numbers::sqrt2},
      {"sqrt(16)", 4},
      {"cbrt(27)", 3},
      {"cbrt(-8)", -2},
      {"abs(-3)", 3},
      {"abs(3)", 3},
      {"sign(-7)", -1},
      {"sign(0)", 0},
      {"sign(0.1)", 1},
      {"floor(2.7)", 2},
      {"floor(-2.1)", -3},
      {"ceil(2.1)", 3},
      {"ceil(-2.7)", -2},
      {"round(2.5)", 3},
      {"round(-2.5)", -3},
      {"round(2.4)", 2},
      {"min(1, 2)", 1},
      {"max(1, 2)", 2},
      {"min(3, 1, 2)", 1},
      {"max(3, 1, 5, 2)", 5},
      {"clamp(5, 0, 1)", 1},
      {"clamp(-5, 0, 1)", 0},
      {"clamp(0.3, 0, 1)", 0.3},
      {"mod(7, 3)", 1},
      {"mod(-1, 3)", 2},
      {"mod(1, -3)", -2},
      {"mod(-7, -3)", -1},
      {"mod(6, 3)", 0},
      {"mod(5.5, 2)", 1.5},
      {"mod(-6, 3)", 0},
      {"hypot(3, 4)", 5},
      {"hypot(2, 3, 6)", 7},
      {"hypot(3e200, 4e200)", 5e200},
      {"step(1, 0.5)", 0},
      {"step(1, 1)", 1},
      {"step(1, 2)", 1},
      {"smoothstep(0, 1, -1)", 0},
      {"smoothstep(0, 1, 0.5)", 0.5},
      {"smoothstep(0, 1, 2)", 1},
      {"smoothstep(0, 2, 0.5)", 0.15625},
      {"smoothstep(1, 0, 0.25)", 0.84375},
      {"SIN(Pi/2)", 1},
      {"sin (0)", 0},
      {"max(min(t, 1), k)", 3},
      // vectors to scalars
      {"(1, 2, 3).x", 1},
      {"(1, 2, 3).y", 2},
      {"(1, 2, 3).z", 3},
      {"dot((1, 2, 3), (4, 5, 6))", 32},
      {"norm((2, 3, 6))", 7},
      {"cross((1, 0, 0), (0, 1, 0)).z", 1},
      {"-(1, 2, 3).y", -2},
      {"(2*(1, 2, 3)).z", 6},
      {"norm(ball.position)^2", 14},
      {"normalize((0, 5, 0)).y", 1},
      {"(t, k, 1).y", 3},
      {"(90 deg, 0, 0).x", kPi / 2},
      {"(0, 180, 0) deg.y", kPi},
      {"(1 < 2 ? (1, 2, 3) : (4, 5, 6)).x", 1},
      // choice
      {"1 < 2 ? 3 : 4", 3},
      {"1 > 2 ? 3 : 4", 4},
      {"t > 1 ? k : -k", 3},
      {"t < 1 ? 1 : t < 2 ? 2 : 3", 3},
      {"true ? 1 : 2", 1},
      {"false ? 1 : true ? 2 : 3", 2},
      {"t == 2 and k == 3 ? 1 : 0", 1},
      {"1 + (t > 1 ? 10 : 20)", 11},
      {"t > 1 ? 1 + 1 : 0", 2},
      {"ball.resting ? 1 : 2", 1},
      {"t == 0 ? 1 : sin(t - t)/1", 0},
      // IEEE 754 passes through
      {"1/0", kInfinity},
      {"-1/0", -kInfinity},
      {"0/0", kNaN},
      {"log(0)", -kInfinity},
      {"sqrt(-1)", kNaN},
      {"asin(2)", kNaN},
      {"1e308*10", kInfinity},
      {"min(0/0, 1)", kNaN},
      {"min(1, 0/0)", kNaN},
      {"max(0/0, 1)", kNaN},
      {"max(1, 0/0)", kNaN},
      {"clamp(0/0, 0, 1)", kNaN},
      {"sign(0/0)", kNaN},
      {"mod(1, 0)", kNaN},
      {"(-8)^(1/3)", kNaN},
      {"t == 2 ? 1 : 1/0", 1},
      {"normalize((0, 0, 0)).x", kNaN},
      {"exp(1000)", kInfinity},
      {"0*(1/0)", kNaN},
  };
  EXPECT_GE(std::size(cases), 150u);
  for (const auto& [text, expected] : cases) {
    const Value found = worth(text);
    EXPECT_EQ(found.type, Type::scalar) << text;
    expect_number(found.v[0], expected, text);
  }
}

struct BooleanCase {
  std::string_view text;
  bool value;
};

TEST(Program, Booleans) {
  const BooleanCase cases[] = {
      {"true", true},
      {"false", false},
      {"1 < 2", true},
      {"2 < 1", false},
      {"1 <= 1", true},
      {"1 > 1", false},
      {"1 >= 1", true},
      {"2 > 1", true},
      {"1 == 1", true},
      {"1 != 1", false},
      {"not true", false},
      {"not 1 < 2", false},
      {"not not true", true},
      {"true and false", false},
      {"true or false", true},
      {"true or false and false", true},
      {"(true or false) and false", false},
      {"not false and false", false},
      {"not (false and false)", true},
      {"1 + 1 == 2", true},
      {"1 < 2 and 2 < 3", true},
      {"(1, 2, 3) == (1, 2, 3)", true},
      {"(1, 2, 3) == (1, 2, 4)", false},
      {"(1, 2, 3) != (1, 2, 4)", true},
      {"true == false", false},
      {"true != false", true},
      {"0/0 == 0/0", false},
      {"0/0 != 0/0", true},
      {"0/0 < 1", false},
      {"not (0/0 >= 1)", true},
      {"true == not false", true},
      {"t > 1 ? false : true", false},
      {"ball.resting", true},
      {"not ball.resting", false},
      {"-1 < 0", true},
      {"TRUE AND NOT FALSE", true},
  };
  for (const auto& [text, expected] : cases) {
    const Value found = worth(text);
    EXPECT_EQ(found.type, Type::boolean) << text;
    EXPECT_EQ(found.v[0], expected ? 1.0 : 0.0) << text;
  }
}

struct VectorCase {
  std::string_view text;
  std::array<double, 3> value;
};

TEST(Program, Vectors) {
  const VectorCase cases[] = {
      {"(1, 2, 3)", {1, 2, 3}},
      {"((1), (2), (3))", {1, 2, 3}},
      {"(0., -0.5, 0.)", {0, -0.5, 0}},
      {"-(1, 2, 3)", {-1, -2, -3}},
      {"+(1, 2, 3)", {1, 2, 3}},
      {"(1, 2, 3) + (4, 5, 6)", {5, 7, 9}},
      {"(1, 2, 3) - (4, 5, 6)", {-3, -3, -3}},
      {"2*(1, 2, 3)", {2, 4, 6}},
      {"(1, 2, 3)*2", {2, 4, 6}},
      {"(1, 2, 3)/2", {0.5, 1, 1.5}},
      {"-2*(1, 2, 3)/2", {-1, -2, -3}},
      {"cross((1, 2, 3), (4, 5, 6))", {-3, 6, -3}},
      {"cross((0, 1, 0), (1, 0, 0))", {0, 0, -1}},
      {"normalize((0, 3, 4))", {0, 0.6, 0.8}},
      {"t > 1 ? (1, 2, 3) : (4, 5, 6)", {1, 2, 3}},
      {"(t, k, t*k)", {2, 3, 6}},
      {"ball.position", {1, 2, 3}},
      {"ball.position*2 - (1, 1, 1)", {1, 3, 5}},
      {"ball.weight", {0, -19.62, 0}},
      {"(0, 0, 90) deg", {0, 0, kPi / 2}},
      {"pull/(4*pi^2)", {-2, -4, -6}},
      {"(1, 2, 3)/0", {kInfinity, kInfinity, kInfinity}},
      {"(1 < 2 ? 1 : 0, -2^2, min(3, 4))", {1, -4, 3}},
      {"normalize(ball.position)*norm(ball.position)", {1, 2, 3}},
  };
  for (const auto& [text, expected] : cases) {
    const Value found = worth(text);
    EXPECT_EQ(found.type, Type::vector) << text;
    for (size_t i = 0; i < 3; ++i) expect_number(found.v[i], expected[i], text);
  }
}

TEST(Program, InputsStandInTheOrderOfTheirFirstMention) {
  const Program program = compile("k*ball.position.z + t + k", example_scope());
  const std::vector<Input> expected = {
      {"k", Type::scalar}, {"ball.position", Type::vector}, {"t", Type::scalar}};
  EXPECT_EQ(program.inputs(), expected);
  EXPECT_EQ(program.input_count(), 5u);
  const std::array<double, 5> inputs = {10, 0, 0, 7, 1};
  double value = 0;
  program.evaluate(inputs.data(), &value);
  EXPECT_EQ(value, 81);
}

TEST(Program, IsConstantWithoutInputsAndKeepsItsText) {
  const Program constant = compile("2*ball.mass + 1", example_scope());
  EXPECT_TRUE(constant.is_constant());
  EXPECT_EQ(constant.constant(), Value::scalar(5));
  EXPECT_EQ(constant.text(), "2*ball.mass + 1");
  EXPECT_FALSE(compile("2*t", example_scope()).is_constant());
  EXPECT_TRUE(compile("(t, 1, 2).y", example_scope()).is_constant());  // t has no say in it
}

}  // namespace
}  // namespace animado::interexpserv
