// src/fred/integrate.cpp: every method converges with its order to closed forms.
#include "fred/integrate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace animado::fred {
namespace {

struct Problem {
  const char* name;
  Derivative derivative;
  std::vector<double> start;
  double t1;
  std::vector<double> exact;  // at t1
};

const std::vector<Problem>& problems() {
  static const std::vector<Problem> kProblems = {
      {"decay", [](double, auto y, auto rate) { rate[0] = -y[0]; }, {1}, 1, {std::exp(-1)}},
      {"oscillator",
       [](double, auto y, auto rate) { rate[0] = y[1], rate[1] = -y[0]; },
       {1, 0},
       2,
       {std::cos(2.0), -std::sin(2.0)}},
      // Not linear and with t on the right: y' = −2 t y², y = 1 / (1 + t²).
      {"witch", [](double t, auto y, auto rate) { rate[0] = -2 * t * y[0] * y[0]; }, {1}, 1.5, {1 / 3.25}},
      // Logistic growth, y = 1 / (1 + 4 e^−t).
      {"logistic",
       [](double, auto y, auto rate) { rate[0] = y[0] * (1 - y[0]); },
       {0.2},
       2,
       {1 / (1 + 4 * std::exp(-2))}},
  };
  return kProblems;
}

double error_after(const Problem& problem, const Tableau& method, int64_t steps) {
  const Solution solution = integrate(problem.derivative, problem.start, {0, problem.t1, steps, 0}, method);
  double error = 0;
  const size_t size = problem.start.size();
  for (size_t i = 0; i < size; ++i)
    error = std::hypot(error, solution.rows[(1 + size) + 1 + i] - problem.exact[i]);
  return error;
}

class Convergence : public testing::TestWithParam<std::tuple<Tableau, Problem>> {};

INSTANTIATE_TEST_SUITE_P(, Convergence,
                         testing::Combine(testing::ValuesIn(tableaus()), testing::ValuesIn(problems())),
                         [](const auto& tested) {
                           return std::get<0>(tested.param).name + "_" + std::get<1>(tested.param).name;
                         });

// Halving the step divides the error by 2^order. 64 and 128 steps: far from rounding, near enough to the
// limit for a tenth of an order.
TEST_P(Convergence, HasTheOrderOfTheMethod) {
  const auto& [method, problem] = GetParam();
  const double order = std::log2(error_after(problem, method, 64) / error_after(problem, method, 128));
  EXPECT_NEAR(order, method.order, 0.1);
}

// t⁰ … t^(order−1) are integrated exactly: the quadrature condition, and the last time is met to the bit.
TEST_P(Convergence, IntegratesPolynomialsOfItsDegree) {
  const Tableau& method = std::get<0>(GetParam());
  const Derivative power = [&](double t, auto, auto rate) {
    rate[0] = method.order * std::pow(t, method.order - 1);
  };
  const Solution solution = integrate(power, std::vector<double>{0}, {0, 0.7, 3, 3}, method);
  ASSERT_EQ(solution.rows.size(), 8u);
  EXPECT_EQ(solution.rows[6], 0.7);
  EXPECT_NEAR(solution.rows[7], std::pow(0.7, method.order), 1e-15);
}

TEST(Integrate, RunsBackwards) {
  const Derivative decay = [](double, auto y, auto rate) { rate[0] = -y[0]; };
  const Solution solution = integrate(decay, std::vector<double>{1}, {1, 0, 100, 0}, tableau_named("rk4"));
  EXPECT_EQ(solution.rows[2], 0);
  EXPECT_NEAR(solution.rows[3], std::numbers::e, 1e-9);
}

TEST(Integrate, SamplesAreSpreadOverTheSteps) {
  const Derivative one = [](double, auto, auto rate) { rate[0] = 1; };
  const Solution solution = integrate(one, std::vector<double>{0}, {0, 10, 10, 4}, tableau_named("euler"));
  EXPECT_EQ(solution.rows, (std::vector<double>{0, 0, 2, 2, 5, 5, 7, 7, 10, 10}));
  EXPECT_EQ(solution.steps, 10);
  EXPECT_EQ(solution.evaluations, 10);
}

// y' = y², y = 1 / (1 − t): the pole at 1 lies inside.
TEST(Integrate, StopsWhereTheSolutionLeavesTheFinite) {
  const Derivative square = [](double, auto y, auto rate) { rate[0] = y[0] * y[0]; };
  const Solution solution = integrate(square, std::vector<double>{1}, {0, 4, 400, 0}, tableau_named("rk4"));
  EXPECT_FALSE(solution.finite);
  EXPECT_GT(solution.steps, 95);
  EXPECT_LT(solution.steps, 120);
}

TEST(Interval, TakesTheFewestStepsThatAreShortEnough) {
  EXPECT_EQ(Interval::divided(0, 1, 0.1, 0).steps, 10);
  EXPECT_EQ(Interval::divided(0, 1.1, 0.1, 0).steps, 11);  // 1.1 / 0.1 is 11.000000000000002
  EXPECT_EQ(Interval::divided(0, 1, 0.3, 0).steps, 4);
  EXPECT_EQ(Interval::divided(1, 0, 0.25, 0).steps, 4);
  EXPECT_EQ(Interval::divided(0, 1, 0, 0).steps, 1000);
  EXPECT_EQ(Interval::divided(0, 1, 0.5, 7).steps, 7);
  EXPECT_EQ(Interval::divided(2, 2, 0.5, 0).steps, 1);
}

}  // namespace
}  // namespace animado::fred
