// src/fred/control.cpp: what the errors of the last steps say about the next one.
#include "fred/control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fred/powers.hpp"
#include "problems.hpp"

namespace animado::fred {
namespace {

TEST(Powers, AreNearThoseOfTwo) {
  for (double x = 1e-30; x < 1e30; x *= 1.07) EXPECT_NEAR(log2_near(x), std::log2(x), 0.01);
  for (double x = -90; x < 90; x += 0.013) EXPECT_NEAR(exp2_near(x) / std::exp2(x), 1, 0.0035);
  for (int whole = -90; whole <= 90; ++whole) {
    EXPECT_EQ(log2_near(std::exp2(whole)), whole);
    EXPECT_EQ(exp2_near(whole), std::exp2(whole));
  }
}

// An error of h^5 that does not change keeps the step whose error is just below 1.
TEST(StepControl, SettlesWhereTheErrorIsSmallEnough) {
  StepControl control(4);
  double h = 1e-3;
  for (int i = 0; i < 100; ++i) {
    control.accept(std::pow(h / 0.1, 5), h);
    h = control.memory().step;
  }
  EXPECT_GT(h, 0.08);
  EXPECT_LT(h, 0.1);
}

// Where each step's error is larger than the last one's of the same length, the next is taken shorter than
// where it has stayed.
TEST(StepControl, SeesAGrowingErrorComing) {
  const auto next = [](double error_before) {
    StepControl control(7);
    control.accept(error_before, 0.1);
    control.accept(0.5, 0.1);
    return control.memory().step;
  };
  EXPECT_LT(next(0.05), 0.8 * next(0.5));
  EXPECT_NEAR(next(0.5), next(0.9), 0.1 * next(0.9));  // a shrinking one is not trusted
}

TEST(StepControl, RefusesWhatIsNoNumber) {
  for (const double error : {1.5, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
    StepControl control(4);
    EXPECT_FALSE(control.accept(error, -0.5));
    EXPECT_LT(control.memory().step, 0);
    EXPECT_GE(control.memory().step, -0.45);
    EXPECT_LE(control.memory().step, -0.1);
  }
}

// A close approach, in an orbit of eccentricity 0.9: without the prediction 66 tries are refused on the
// way, with it 5.
TEST(StepControl, RefusesFewTriesOfACloseApproach) {
  Function f = [](double, auto y, auto rate) {
    const double square = y[0] * y[0] + y[1] * y[1], pull = 1 / (square * std::sqrt(square));
    rate[0] = y[2], rate[1] = y[3], rate[2] = -pull * y[0], rate[3] = -pull * y[1];
  };
  const auto stepper = adaptive_stepper(method_named("dop853"), problem_of(f, {0.1, 0, 0, std::sqrt(19.0)}),
                                        {Tolerance({1e-9}, {1e-9}, 4), 0});
  Goal goal;
  goal.t1 = 20;
  const Solution solution = integrate(*stepper, goal);
  EXPECT_LT(10 * stepper->refused(), solution.steps);
}

}  // namespace
}  // namespace animado::fred
