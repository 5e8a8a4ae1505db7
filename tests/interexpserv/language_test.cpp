// The language by examples: every line of language_values.txt is an expression and what it is worth.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

class ExampleScope : public MapScope {
 public:
  ExampleScope() {
    input("t", Type::scalar).input("k", Type::scalar).input("v", Type::vector).input("flag", Type::boolean);
    define("square", "(x) = x^2").define("mix", "(a, b, s) = a + s*(b - a)");
    define("length", "(v) = norm(v)").define("both", "(p, q) = p and q");
    define("twice", "(x) = 2*x").define("slope", "(x) = d(square(x) + k*x + twice(x), x) + x - k - x + 1");
    define("broken", "(x) = x + nothing")
        .define("ring", "(x) = chain(x)")
        .define("chain", "(x) = ring(x) + 1");
  }
  std::string path_of(std::string_view written) const override {
    return ANIMADO_SOURCE_DIR "/tests/interexpserv/" + std::string(written);
  }
};

std::vector<double> example_inputs(const Program& program) {
  const std::map<std::string, std::vector<double>> values = {
      {"t", {2}}, {"k", {3}}, {"v", {1, 2, 3}}, {"flag", {1}}};
  std::vector<double> inputs;
  for (const Input& input : program.inputs()) {
    const std::vector<double>& value = values.at(input.name);
    inputs.insert(inputs.end(), value.begin(), value.end());
  }
  return inputs;
}

struct Example {
  std::string text;
  std::vector<double> values;
};

std::vector<Example> examples() {
  std::ifstream file(ANIMADO_SOURCE_DIR "/tests/interexpserv/language_values.txt");
  std::vector<Example> all;
  for (std::string line; std::getline(file, line);) {
    const size_t arrow = line.find(" => ");
    if (line.starts_with('#') || arrow == std::string::npos) continue;
    std::istringstream numbers(line.substr(arrow + 4));
    Example example{line.substr(0, arrow), {}};
    for (std::string number; numbers >> number;) example.values.push_back(std::stod(number));
    all.push_back(std::move(example));
  }
  return all;
}

// Four units in the last place: two roundings more than the worst function.
void expect_number(double found, double expected, const std::string& text) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(found)) << text << " is " << found;
  } else {
    EXPECT_DOUBLE_EQ(found, expected) << text;
  }
}

TEST(Language, Values) {
  const ExampleScope scope;
  const std::vector<Example> all = examples();
  EXPECT_GE(all.size(), 500u);
  for (const auto& [text, expected] : all) {
    const Program program = compile(text, scope, text);
    ASSERT_EQ(width_of(program.type()), expected.size()) << text;
    std::array<double, 3> value{};
    program.evaluate(example_inputs(program).data(), value.data());
    for (size_t k = 0; k < expected.size(); ++k) expect_number(value[k], expected[k], text);
  }
}

// Folded while it is read, or computed from inputs: the same bits. And the same in every lane of every width.
TEST(Language, BatchesHaveTheBitsOfOneEvaluation) {
  const ExampleScope scope;
  for (const auto& [text, expected] : examples()) {
    const Program program = compile(text, scope, text);
    const std::vector<double> inputs = example_inputs(program);
    std::array<double, 3> value{};
    program.evaluate(inputs.data(), value.data());
    constexpr size_t count = 19;
    std::vector<std::vector<double>> rows(inputs.size(), std::vector<double>(count));
    std::vector<Lanes> lanes;
    for (size_t i = 0; i < inputs.size(); ++i) {
      for (size_t k = 0; k < count; ++k) rows[i][k] = inputs[i];
      lanes.push_back({rows[i].data(), i % 2 == 1});
    }
    for (int set = 0; set <= static_cast<int>(best_instruction_set()); ++set) {
      std::vector<double> out(3 * count, -1);
      const std::array<double*, 3> outs = {&out[0], &out[count], &out[2 * count]};
      program.evaluate_batch(lanes, count, std::span(outs).first(expected.size()),
                             static_cast<InstructionSet>(set));
      for (size_t k = 0; k < expected.size() * count; ++k) {
        const double one = value[k / count];
        EXPECT_TRUE(out[k] == one || (std::isnan(out[k]) && std::isnan(one))) << text << " " << set;
      }
    }
  }
}

struct ErrorCase {
  std::string_view text, code;
  size_t column;
  std::string_view says, remedy;
};

TEST(Language, Mistakes) {
  const ErrorCase cases[] = {
      {"10 cm + 2 s", "type", 6, "`+` of a length (m) and a time (s)", "without a unit"},
      {"2 kg - 1 m", "type", 5, "`-` of a mass (kg) and a length (m)", ""},
      {"1 m < 1 s", "type", 4, "a length (m) and a time (s)", ""},
      {"min(1 kg, 1 m)", "type", 0, "`min` of", "measure the same"},
      {"sin(3 m)", "type", 0, "`sin` of a length (m)", "pure number or an angle"},
      {"exp(2 s)", "type", 0, "`exp` of a time (s)", ""},
      {"2^(1 m)", "type", 1, "`^` of a length", ""},
      {"(1 m, 2 s, 3 m)", "type", 0, "a length (m) and a time (s)", ""},
      {"t > 1 ? 1 m : 1 s", "type", 6, "a length (m) and a time (s)", ""},
      {"if(flag, 1 N, 1 J)", "type", 0, "a force (kg m s^-2)", ""},
      {"1 m^2 + 1 m", "type", 6, "an area (m^2) and a length (m)", ""},
      {"90 deg + 1 m", "type", 7, "a number or an angle and a length", ""},
      {"(2 m) s", "type", 6, "a unit stands behind a number without one", "once"},
      {"true s", "syntax", 5, "expected an operator", ""},
      {"(t > 1) m", "type", 8, "behind a number", ""},
      {"3 cmm", "syntax", 2, "found `cmm`", "`cm`"},
      {"3 mn", "syntax", 2, "expected an operator", ""},
      {"3 m^t", "syntax", 4, "whole number", "(…)"},
      {"3 m^0.5", "syntax", 4, "whole number", ""},
      {"3 m^9", "syntax", 4, "at most 6", ""},
      {"f(x) = 2", "syntax", 5, "`=` is no operator", "f(x) = …"},
      {"(x, x) = 2", "syntax", 4, "two parameters `x`", ""},
      {"(pi) = 2", "syntax", 1, "`pi` is a word of the language", ""},
      {"(x) = ", "syntax", 6, "found the end", ""},
      {"(a, b, c, d, e1, f, g, h, i) = 1", "limit", 0, "9 parameters", "at most 8"},
      {"square(1, 2)", "type", 0, "`square` takes 1 value, not 2", "square(x) = x^2"},
      {"mix(1)", "type", 0, "`mix` takes 3 values, not 1", ""},
      {"square()", "syntax", 7, "found `)`", ""},
      {"square(v)", "type", 0, "in the definition of `square`: `^` takes", "dot(v, v)"},
      {"length(2)", "type", 0, "`norm` takes (vector), not (scalar)", "abs(x)"},
      {"square", "syntax", 0, "`square` is a function", "square(…)"},
      {"sqare(2)", "unknown_name", 0, "unknown function `sqare`", "square"},
      {"broken(2)", "unknown_name", 0, "in the definition of `broken`: unknown name `nothing`", ""},
      {"ring(1)", "cycle", 0, "ring → chain → ring", "does not need"},
      {"flag(2)", "syntax", 0, "`flag` is a value", "flag * (…)"},
      {"if(1, 2, 3)", "type", 0, "`if` takes", ""},
      {"if(flag, 2)", "type", 0, "not (boolean, scalar)", ""},
      {"if(flag, v, 1)", "type", 0, "not (boolean, vector, scalar)", ""},
      {"if flag", "syntax", 3, "expected an operator", ""},
      {"table(\"ramp.csv\")", "type", 0, "`table` takes (text, scalar)", ""},
      {"table(t, t)", "type", 0, "not (scalar, scalar)", ""},
      {"table(\"ramp.csv\", v)", "type", 0, "not (text, vector)", ""},
      {"table(\"no.csv\", t)", "unknown_name", 6, "no table", "check the path"},
      {"table(\"ramp.csv\", t, \"curved\")", "unknown_name", 21, "unknown interpolation `curved`",
       "linear or cubic"},
      {"table(\"language_values.txt\", t)", "syntax", 6, "does not begin with two numbers", "x, y"},
      {"\"text\"", "type", 0, "a text is no value", "table"},
      {"1 + \"text\"", "type", 2, "", ""},
      {"square(\"text\")", "type", 7, "a text is no value", ""},
      {"\"open", "syntax", 0, "never closed", ""},
      {"d(t^2, 3)", "type", 7, "needs a variable", "d(f, t)"},
      {"d(t^2, t + 1)", "type", 9, "needs a variable", ""},
      {"d(t^2, pi)", "type", 7, "`pi` does not vary", ""},
      {"d(t)", "type", 0, "`d` takes", ""},
      {"d(v, v)", "type", 0, "not (vector, vector)", ""},
      {"d(flag, t)", "type", 0, "not (boolean, scalar)", ""},
      {"random(1)", "type", 0, "takes (scalar, scalar)", ""},
      {"noise(v, t)", "type", 0, "not (vector, scalar)", ""},
      {"1 m + d(1 s * t, t) / 1 kg + 1 kg", "type", 27, "a length (m) and a mass (kg)", ""},
  };
  const ExampleScope scope;
  for (const ErrorCase& expected : cases) {
    try {
      compile(expected.text, scope, "here");
      ADD_FAILURE() << expected.text << " was accepted";
    } catch (const ExpressionError& error) {
      EXPECT_EQ(name_of(error.code()), expected.code) << expected.text << "\n" << error.what();
      EXPECT_EQ(error.column(), expected.column) << expected.text << "\n" << error.what();
      EXPECT_NE(error.message().find(expected.says), std::string::npos) << expected.text << "\n"
                                                                        << error.what();
      EXPECT_NE(error.remedy().find(expected.remedy), std::string::npos) << expected.text << "\n"
                                                                         << error.what();
    }
  }
}

TEST(Language, AUnitThatIsANameIsRefusedNotGuessed) {
  MapScope scope;
  scope.set("h", Value::scalar(2));
  EXPECT_EQ(compile("10 m / h", scope).constant().v[0], 5);
  EXPECT_THROW(compile("10 m/h", scope), ExpressionError);
  EXPECT_EQ(compile("36 m/h", MapScope()).constant().v[0], 0.01);
}

TEST(Language, DefinitionsKeepTheirDimension) {
  MapScope scope;
  scope.define("wall", "3 m").define("wait", "2 s");
  EXPECT_EQ(compile("wall + 1 m", scope).constant().v[0], 4);
  EXPECT_THROW(compile("wall + wait", scope), ExpressionError);
}

TEST(Language, AFunctionByItselfIsReadForTheTypesThatItTakes) {
  const MapScope scope;
  EXPECT_EQ(compile("(x) = x^2", scope).type(), Type::scalar);
  EXPECT_EQ(compile("(v) = dot(v, v)", scope).inputs()[0].type, Type::vector);
  EXPECT_EQ(compile("(c, v) = c ? v : -v", scope).inputs()[0].type, Type::boolean);
  EXPECT_THROW(compile("(x) = x + nothing", scope), ExpressionError);
  EXPECT_THROW(compile("(x) = sin(x) and x", scope), ExpressionError);
}

TEST(Language, RandomNumbersAreEvenAndReproducible) {
  MapScope scope;
  scope.input("k", Type::scalar);
  const Program random = compile("random(7, k)", scope), gauss = compile("gauss(7, k)", scope);
  double sum = 0, squares = 0, normal = 0, normal_squares = 0;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const double k = i;
    double u, g;
    random.evaluate(&k, &u);
    gauss.evaluate(&k, &g);
    ASSERT_TRUE(u >= 0 && u < 1);
    sum += u, squares += u * u, normal += g, normal_squares += g * g;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * 0.29 / std::sqrt(n));  // five standard deviations
  EXPECT_NEAR(squares / n, 1.0 / 3, 5 * 0.3 / std::sqrt(n));
  EXPECT_NEAR(normal / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(normal_squares / n, 1, 5 * std::sqrt(2.0 / n));
  const double zero = 0;
  double u;
  compile("random(0, k)", scope).evaluate(&zero, &u);
  EXPECT_EQ(u, std::ldexp((0x6627e8d5ull << 20) ^ (0xe169c58dull & 0xfffff), -52));  // [SAL11]'s first answer
}

}  // namespace
}  // namespace animado::interexpserv
