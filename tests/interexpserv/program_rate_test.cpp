// src/interexpserv/program.cpp: rates of change are derivatives.
#include <gtest/gtest.h>

#include <numbers>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

struct Case {
  std::string_view text;
  double value;
};

MapScope scope_of_rates() {
  MapScope scope;
  scope.input("t", Type::scalar).input("ball.position", Type::vector);
  return scope;
}

// d/dt of f(t) at 0.3 beside the derivative in closed form.
TEST(Program, RatesAreDerivatives) {
  const double t = 0.3, s = std::sin(t), c = std::cos(t);
  const Case cases[] = {
      {"5", 0},
      {"t", 1},
      {"-t", -1},
      {"3*t + 2", 3},
      {"t^2", 2 * t},
      {"t^3", 3 * t * t},
      {"t*t*t", 3 * t * t},
      {"2^t", std::pow(2, t) * std::log(2)},
      {"t^t", std::pow(t, t) * (std::log(t) + 1)},
      {"1/t", -1 / (t * t)},
      {"(1 + t)/(1 - t)", 2 / ((1 - t) * (1 - t))},
      {"sin(t)", c},
      {"cos(t)", -s},
      {"tan(t)", 1 / (c * c)},
      {"asin(t)", 1 / std::sqrt(1 - t * t)},
      {"acos(t)", -1 / std::sqrt(1 - t * t)},
      {"atan(t)", 1 / (1 + t * t)},
      {"atan2(sin(t), cos(t))", 1},
      {"atan2(t, 2)", 2 / (4 + t * t)},
      {"sinh(t)", std::cosh(t)},
      {"cosh(t)", std::sinh(t)},
      {"tanh(t)", 1 - std::tanh(t) * std::tanh(t)},
      {"exp(2*t)", 2 * std::exp(2 * t)},
      {"log(t)", 1 / t},
      {"log10(t)", 1 / (t * std::log(10.0))},
      {"sqrt(t)", 0.5 / std::sqrt(t)},
      {"cbrt(t)", std::cbrt(t) / (3 * t)},
      {"abs(t)", 1},
      {"abs(-t)", 1},
      {"abs(t - 1)", -1},
      {"sign(t)", 0},
      {"floor(10*t)", 0},
      {"ceil(t)", 0},
      {"round(t)", 0},
      {"min(t, 1)", 1},
      {"min(1, t)", 1},
      {"max(t, 1)", 0},
      {"max(2*t, t)", 2},
      {"clamp(t, 0, 0.1)", 0},
      {"clamp(t, 0, 1)", 1},
      {"mod(10*t, 2)", 10},
      {"mod(7, t)", -23},
      {"hypot(t, 4*t/3)", 5.0 / 3},
      {"step(0.1, t)", 0},
      {"smoothstep(0, 1, t)", 6 * t * (1 - t)},
      {"t < 1 ? t^2 : t", 2 * t},
      {"t > 1 ? t^2 : t", 1},
      {"norm((3*t, 4*t, 0))", 5},
      {"dot((t, 1, 2), (1, t, t))", 4},
      {"cross((t, 0, 0), (0, t, 0)).z", 2 * t},
      {"normalize((t, t, 0)).x", 0},
      {"90 deg*t", std::numbers::pi / 2},
      {"sqrt(0*t)", 0},
      {"hypot(0*t, 0*t)", 0},
      {"(-2)^2*t", 4},
      {"(-t)^2", 2 * t},
      {"(t - 1)^3", 3 * (t - 1) * (t - 1)},
  };
  for (const auto& [text, expected] : cases) {
    const Program program = compile(text, scope_of_rates());
    const double rate_in = 1;
    double value = 0, plain = 0, rate = 0;
    program.evaluate_with_rate(&t, &rate_in, &value, &rate);
    program.evaluate(&t, &plain);
    EXPECT_EQ(value, plain) << text;
    EXPECT_NEAR(rate, expected, 1e-14 * (1 + std::fabs(expected))) << text;  // some ten roundings
  }
}

TEST(Program, TheRateOfAVectorFollowsAllInputs) {
  const Program program = compile("t*ball.position", scope_of_rates());
  const std::array<double, 4> inputs = {2, 1, 2, 3}, rates = {1, 10, 20, 30};
  std::array<double, 3> value{}, rate{};
  program.evaluate_with_rate(inputs.data(), rates.data(), value.data(), rate.data());
  EXPECT_EQ(value, (std::array<double, 3>{2, 4, 6}));
  EXPECT_EQ(rate, (std::array<double, 3>{21, 42, 63}));
}

}  // namespace
}  // namespace animado::interexpserv
