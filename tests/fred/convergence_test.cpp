// The conformance suite: what every method must do, whatever kind it is. Its order, the order of its dense
// output, and a tolerance that is kept.
#include <gtest/gtest.h>

#include "problems.hpp"

namespace animado::fred {
namespace {

struct Known {
  const char* name;
  Function f;
  std::vector<double> start;
  double t1;
  std::function<std::vector<double>(double t)> exact;
  bool separable = false;
};

std::vector<double> one(double y) {
  return {y};
}

const std::vector<Known>& known_problems() {
  static const std::vector<Known> kProblems = {
      {"decay",
       [](double, auto y, auto rate) { rate[0] = -y[0]; },
       {1},
       2,
       [](double t) { return one(std::exp(-t)); }},
      {"oscillator",
       [](double, auto y, auto rate) { rate[0] = y[1], rate[1] = -y[0]; },
       {1, 0},
       2,
       [](double t) {
         return std::vector{std::cos(t), -std::sin(t)};
       },
       true},
      // Not linear and with t on the right: y' = −2 t y².
      {"witch",
       [](double t, auto y, auto rate) { rate[0] = -2 * t * y[0] * y[0]; },
       {1},
       1.5,
       [](double t) { return one(1 / (1 + t * t)); }},
      {"logistic",
       [](double, auto y, auto rate) { rate[0] = y[0] * (1 - y[0]); },
       {0.2},
       2,
       [](double t) { return one(1 / (1 + 4 * std::exp(-t))); }},
      // q'' = 2 q³: a force that is not linear, and with t: q = 1 / (2 − t).
      {"rush",
       [](double, auto y, auto rate) { rate[0] = y[1], rate[1] = 2 * y[0] * y[0] * y[0]; },
       {0.5, 0.25},
       1,
       [](double t) {
         return std::vector{1 / (2 - t), 1 / ((2 - t) * (2 - t))};
       },
       true},
  };
  return kProblems;
}

class EveryMethod : public testing::TestWithParam<Method> {
 protected:
  static std::vector<Known> problems() {
    std::vector<Known> fitting;
    for (const Known& known : known_problems()) {
      if (GetParam().kind != MethodKind::symplectic || known.separable) fitting.push_back(known);
    }
    return fitting;
  }
};

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(methods()),
                         [](const auto& tested) { return tested.param.name; });

// Halving the step divides the error by 2^order. So many steps that the error is far from rounding and near
// its limit: then the order comes out within a tenth of itself.
TEST_P(EveryMethod, ConvergesWithItsOrder) {
  const Method& method = GetParam();
  const int64_t steps = method.order >= 8 ? 3 : method.order == 5 ? 16 : 64;
  for (const Known& known : problems()) {
    const auto error = [&](int64_t count) {
      return distance(in_equal_steps(method.name, known.f, known.start, known.t1, count).y,
                      known.exact(known.t1));
    };
    const double order = std::log2(error(steps) / error(2 * steps));
    // More is a cancellation that this problem happens to allow.
    EXPECT_GT(order, 0.9 * method.order) << known.name;
    EXPECT_LT(order, 1.4 * method.order + 0.1) << known.name;
  }
}

// t⁰ … t^(order−1) are integrated exactly: the quadrature condition, and the last time is met to the bit.
TEST_P(EveryMethod, IntegratesPolynomialsOfItsDegree) {
  const Method& method = GetParam();
  if (method.kind == MethodKind::symplectic) return;  // a quadrature has no momenta
  const Function power = [&](double t, auto, auto rate) {
    rate[0] = method.order * std::pow(t, method.order - 1);
  };
  const Solution solution = in_equal_steps(method.name, power, {0}, 0.7, 3);
  EXPECT_EQ(solution.t, 0.7);
  EXPECT_NEAR(solution.y[0], std::pow(0.7, method.order), method.name == "verner87" ? 2e-15 : 1e-15);
}

// Inside a step, from its exact start, the error of u(θ) shrinks with h^(dense_order + 1).
TEST_P(EveryMethod, IsDenseWithItsOrder) {
  const Method& method = GetParam();
  for (const Known& known : problems()) {
    const auto error = [&](double h) {
      Function f = known.f;
      const auto stepper = equal_stepper(method, problem_of(f, known.start), h);
      EXPECT_EQ(stepper->step(h), Stepper::Outcome::stepped);
      double worst = 0;
      std::vector<double> inside(known.start.size());
      for (const double theta : {0.15, 0.4, 0.6, 0.85}) {
        stepper->interpolate(theta * h, inside);
        worst = std::max(worst, distance(inside, known.exact(theta * h)));
      }
      return worst;
    };
    const double h = method.dense_order >= 8 ? 0.8 : method.dense_order == 7 ? 0.4 : 0.1;
    const double order = std::log2(error(h) / error(h / 2)) - 1;
    const double slack = method.dense_order >= 8 ? 0.5 : 0.35;  // rounding is near where h is small enough
    EXPECT_GT(order, std::min(method.dense_order, method.order) - slack) << known.name;
  }
}

TEST_P(EveryMethod, IsDenseWithoutAJumpAtTheEndsOfAStep) {
  Function f = known_problems()[1].f;
  const auto stepper = equal_stepper(GetParam(), problem_of(f, {1, 0}), 0.1);
  ASSERT_EQ(stepper->step(1), Stepper::Outcome::stepped);
  std::vector<double> start(2), end(2);
  stepper->interpolate(0, start);
  stepper->interpolate(std::nextafter(0.1, 0), end);
  EXPECT_NEAR(start[0], 1, 1e-15);
  EXPECT_NEAR(start[1], 0, 1e-15);
  EXPECT_NEAR(distance(end, stepper->y()), 0, 1e-15);
}

class EveryAdaptiveMethod : public EveryMethod {};

std::vector<Method> adaptive_methods() {
  std::vector<Method> adaptive;
  for (const Method& method : methods()) {
    if (method.is_adaptive()) adaptive.push_back(method);
  }
  return adaptive;
}

INSTANTIATE_TEST_SUITE_P(, EveryAdaptiveMethod, testing::ValuesIn(adaptive_methods()),
                         [](const auto& tested) { return tested.param.name; });

// The tolerance bounds the error of a step; over these short problems it adds up to some of them, the more
// the lower the order. A tenth of the tolerance asks for more work.
TEST_P(EveryAdaptiveMethod, KeepsTheTolerance) {
  for (const Known& known : problems()) {
    int64_t evaluations = 0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Solution solution = adaptively(GetParam().name, known.f, known.start, known.t1, tolerance);
      EXPECT_EQ(solution.stop, Stop::end);
      EXPECT_EQ(solution.t, known.t1);
      EXPECT_LT(distance(solution.y, known.exact(known.t1)), 100 * tolerance)
          << known.name << " " << tolerance;
      EXPECT_GE(solution.steps, evaluations) << known.name;
      evaluations = solution.steps;
    }
  }
}

// Also where it begins is found by itself: forty decades of scale make no difference.
TEST_P(EveryAdaptiveMethod, FindsItsFirstStepWhateverTheScale) {
  for (const double scale : {1e-20, 1.0, 1e20}) {
    const Function f = [scale](double, auto y, auto rate) {
      rate[0] = y[1] / scale, rate[1] = -y[0] / scale;
    };
    const Solution solution = adaptively(GetParam().name, f, {1, 0}, scale, 1e-6);
    EXPECT_EQ(solution.stop, Stop::end);
    EXPECT_NEAR(solution.y[0], std::cos(1), 2e-5);
    EXPECT_LT(solution.steps, 100);
  }
}

TEST_P(EveryAdaptiveMethod, RunsBackwards) {
  const Solution solution = adaptively(GetParam().name, known_problems()[0].f, {1}, -1, 1e-8);
  EXPECT_EQ(solution.t, -1);
  EXPECT_NEAR(solution.y[0], std::exp(1), 1e-6);
}

}  // namespace
}  // namespace animado::fred
