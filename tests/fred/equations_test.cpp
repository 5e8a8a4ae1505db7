// src/fred/equations.cpp: systems written as expressions, and what is said about those that make no sense.
#include "fred/equations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace animado::fred {
namespace {

using Texts = std::vector<std::string>;

TEST(Equations, AreEvaluatedAtTimeAndUnknowns) {
  const Equations equations(Texts{"x' = v", "v' = -k*x + t", "idle' = 7"}, {{"k", 3}});
  EXPECT_EQ(equations.unknowns(), (Texts{"x", "v", "idle"}));
  std::vector<double> rate(3);
  equations.evaluate(10, std::vector<double>{2, 5, 0}, rate);
  EXPECT_EQ(rate, (std::vector<double>{5, 4, 7}));
}

TEST(Equations, NamesAreFolded) {
  const Equations equations(Texts{"Posição' = 2*POSICAO"}, {});
  EXPECT_EQ(equations.arranged({{"posicao", 4}}), (std::vector<double>{4}));
  std::vector<double> rate(1);
  equations.evaluate(0, std::vector<double>{4}, rate);
  EXPECT_EQ(rate[0], 8);
}

TEST(Equations, ValuesAreArrangedInTheOrderOfTheEquations) {
  const Equations equations(Texts{"x' = 0", "y' = 0"}, {});
  EXPECT_EQ(equations.arranged({{"y", 2}, {"x", 1}}), (std::vector<double>{1, 2}));
}

TEST(Equations, OtherNamesAreLookedUpOnceAndConstantsWin) {
  int asked = 0;
  const Lookup lookup = [&](std::string_view name) -> std::optional<interexpserv::Value> {
    asked += name == "spring.k" ? 1 : 0;
    if (name == "spring.k") return interexpserv::Value::scalar(5);
    if (name == "wind") return interexpserv::Value::vector(1, 2, 3);
    if (name == "mass") return interexpserv::Value::scalar(1e9);
    return {};
  };
  const Equations equations(Texts{"x' = spring.k*x/mass", "y' = spring.k + wind.z"}, {{"mass", 2}}, lookup);
  std::vector<double> rate(2);
  equations.evaluate(0, std::vector<double>{4, 0}, rate);
  EXPECT_EQ(rate, (std::vector<double>{10, 8}));
  EXPECT_EQ(asked, 1);
}

TEST(Equations, AreDifferentiatedExactly) {
  const Equations equations(Texts{"x' = x*y + t", "y' = sin(x)", "z' = z^2"}, {});
  std::vector<double> jacobian(9);
  equations.differentiate(7, std::vector<double>{2, 3, 5}, jacobian);
  EXPECT_EQ(jacobian, (std::vector<double>{3, 2, 0, std::cos(2.0), 0, 0, 0, 0, 10}));
}

TEST(Equations, MayDefineWhatTheyUse) {
  const Equations equations(
      Texts{"w0 = 2*pi", "x' = v", "Pull(x, k) = -k*x^3", "v' = pull(x, w0) + shift.y", "shift = (0, t, 0)"},
      {});
  EXPECT_EQ(equations.unknowns(), (Texts{"x", "v"}));
  EXPECT_EQ(equations.place(1), "equations[3]");
  std::vector<double> rate(2), jacobian(4);
  equations.evaluate(5, std::vector<double>{1, 7}, rate);
  EXPECT_EQ(rate, (std::vector<double>{7, 5 - 2 * std::numbers::pi}));
  equations.differentiate(5, std::vector<double>{1, 7}, jacobian);
  EXPECT_EQ(jacobian, (std::vector<double>{0, 1, -6 * std::numbers::pi, 0}));
  EXPECT_EQ(equations.read_by(1), (std::vector<size_t>{0}));
  EXPECT_EQ(equations.expression("pull(2, 1)", "events[0]")(0, std::vector<double>{1, 7}), -8);
}

TEST(Equations, OtherExpressionsReadTheSameNames) {
  const Equations equations(Texts{"x' = 1", "y' = 1"}, {{"k", 10}});
  const auto value = [&](std::string_view text) {
    return equations.expression(text, "events[0]")(3, std::vector<double>{1, 2});
  };
  EXPECT_EQ(value("k*x + y - t"), 9);
  EXPECT_EQ(value("y = 5"), -3);
  EXPECT_THROW(value("x >= 5"), Error) << "a comparison does not cross zero";
}

struct EquationMistake {
  const char* name;
  Texts texts;
  NamedValues constants, from;
  Code code;
  const char* where;
};

class RefusedEquations : public testing::TestWithParam<EquationMistake> {};

INSTANTIATE_TEST_SUITE_P(
    , RefusedEquations,
    testing::Values(
        EquationMistake{"no_prime", {"x = 1"}, {}, {}, Code::syntax, "equations[0]"},
        EquationMistake{
            "definition_of_an_unknown", {"x' = 1", "x = 2"}, {}, {}, Code::conflict, "equations[1]"},
        EquationMistake{
            "defined_and_given", {"x' = k", "k = 2"}, {{"k", 1}}, {}, Code::conflict, "constants[0]"},
        EquationMistake{"bad_definition", {"x' = 1", "f(x) = x +"}, {}, {}, Code::syntax, "equations[1]"},
        EquationMistake{
            "unused_definition", {"x' = 1", "k = 2*w"}, {}, {}, Code::unknown_name, "equations[1]"},
        EquationMistake{"need_each_other", {"x' = a", "a = b", "b = a"}, {}, {}, Code::cycle, "equations[1]"},
        EquationMistake{"known_function", {"x' = 1", "sin(x) = x"}, {}, {}, Code::conflict, "equations[1]"},
        EquationMistake{"no_equals", {"x' = 1", "y'"}, {}, {}, Code::syntax, "equations[1]"},
        EquationMistake{"no_name", {"2x' = 1"}, {}, {}, Code::syntax, "equations[0]"},
        EquationMistake{"second_order", {"x'' = -x"}, {}, {}, Code::syntax, "equations[0]"},
        EquationMistake{"reserved", {"t' = 1"}, {}, {}, Code::conflict, "equations[0]"},
        EquationMistake{"unknown_twice", {"x' = 1", "X' = 2"}, {}, {}, Code::conflict, "equations[1]"},
        EquationMistake{"constant_is_unknown", {"x' = 1"}, {{"x", 1}}, {}, Code::conflict, "constants[0]"},
        EquationMistake{"bad_expression", {"x' = 1 +"}, {}, {}, Code::syntax, "equations[0]"},
        EquationMistake{"undefined", {"x' = w"}, {}, {{"x", 1}}, Code::unknown_name, "equations[0]"},
        EquationMistake{"vector", {"x' = (1, 2, 3)"}, {}, {}, Code::type, "equations[0]"},
        EquationMistake{"no_start", {"x' = 1"}, {}, {}, Code::bad_params, "from"},
        EquationMistake{
            "start_of_nothing", {"x' = 1"}, {}, {{"x", 1}, {"y", 1}}, Code::unknown_name, "from[1]"},
        EquationMistake{"start_twice", {"x' = 1"}, {}, {{"x", 1}, {"x", 1}}, Code::conflict, "from[1]"}),
    [](const auto& tested) { return tested.param.name; });

TEST_P(RefusedEquations, SayWhatIsWrongAndWhere) {
  try {
    Equations(GetParam().texts, GetParam().constants).arranged(GetParam().from);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), GetParam().code) << error.message();
    EXPECT_NE(error.where().find(GetParam().where), std::string::npos) << error.where();
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST(RefusedEquation, OfSecondOrderIsToldHowItBecomesTwo) {
  try {
    Equations(Texts{"x'' = -x"}, {});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.remedy(), testing::HasSubstr("x' = v; v' = "));
  }
}

}  // namespace
}  // namespace animado::fred
