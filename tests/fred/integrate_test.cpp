// src/fred/integrate.cpp: samples, events on the way, checkpoints, and why an integration ends.
#include "fred/integrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "fred/equal_steps.hpp"
#include "problems.hpp"

namespace animado::fred {
namespace {

using testing::ElementsAre;

void oscillate(double, std::span<const double> y, std::span<double> rate) {
  rate[0] = y[1];
  rate[1] = -y[0];
}

EventRule zero_of_x(bool terminal = false, Crossing crossing = Crossing::any) {
  return {[](double, auto y) { return y[0]; }, crossing, terminal};
}

TEST(Integrate, SamplesWhereItIsAsked) {
  Goal goal;
  goal.times = {0, 0.5, 0.5, 2.25, 3};
  const Solution solution = adaptively("dop853", oscillate, {1, 0}, 3, 1e-12, goal);
  ASSERT_EQ(solution.rows.size(), 15u);
  for (size_t row = 0; row < 5; ++row) {
    EXPECT_EQ(solution.rows[3 * row], goal.times[row]);
    EXPECT_NEAR(solution.rows[3 * row + 1], std::cos(goal.times[row]), 1e-10);
  }
}

TEST(Integrate, CountsEvaluationsAsTheTableauDoes) {
  const auto count = [](const std::string& method) {
    Function f = oscillate;
    const auto stepper = equal_stepper(method_named(method), problem_of(f, {1, 0}), 0.1);
    Goal goal;
    goal.t1 = 1;
    integrate(*stepper, goal);
    return stepper->evaluations();
  };
  EXPECT_EQ(count("rk4"), 40);
  EXPECT_EQ(count("dopri5"), 60);
  EXPECT_EQ(count("dop853"), 120);
  EXPECT_EQ(count("verlet"), 30);
}

// Each crossing of cos t is at (k + ½)π: found to 1e-12 where the solution itself is that good.
TEST(Integrate, LocatesCrossings) {
  Goal goal;
  goal.events = {zero_of_x()};
  const Solution solution = adaptively("dop853", oscillate, {1, 0}, 20, 1e-14, goal);
  ASSERT_EQ(solution.events.size(), 6u);
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(solution.events[k].t, (static_cast<double>(k) + 0.5) * std::numbers::pi, 1e-12);
    EXPECT_EQ(solution.events[k].rising, k % 2 == 1);
  }
}

// A clock that crosses at known times: what is left is the error of the search.
TEST(Integrate, LocatesCrossingsToTheLastBits) {
  Goal goal;
  goal.events = {{[](double t, auto) { return std::sin(t); }}};
  const Solution solution = adaptively("bs23", oscillate, {1, 0}, 20, 1e-3, goal);
  ASSERT_EQ(solution.events.size(), 6u);
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(solution.events[k].t, static_cast<double>(k + 1) * std::numbers::pi, 1e-14);
  }
}

TEST(Integrate, TellsDirections) {
  for (const auto crossing : {Crossing::rising, Crossing::falling}) {
    Goal goal;
    goal.events = {zero_of_x(false, crossing)};
    const Solution solution = adaptively("dopri5", oscillate, {1, 0}, 20, 1e-8, goal);
    ASSERT_EQ(solution.events.size(), 3u);
    for (const Occurrence& event : solution.events) EXPECT_EQ(event.rising, crossing == Crossing::rising);
  }
}

// x' = 1 in one step of length 10: the three crossings lie in one step, and come in order.
TEST(Integrate, FindsSeveralCrossingsInOneStep) {
  Goal goal;
  for (const double at : {7.0, 2.0, 3.5}) goal.events.push_back({[at](double, auto y) { return y[0] - at; }});
  goal.events[2].terminal = true;
  const Function one = [](double, auto, auto rate) { rate[0] = 1; };
  const Solution solution = in_equal_steps("rk4", one, {0}, 10, 1);
  EXPECT_EQ(solution.steps, 1);
  Function f = one;
  const auto stepper = equal_stepper(method_named("rk4"), problem_of(f, {0}), 10);
  goal.t1 = 10;
  const Solution found = integrate(*stepper, goal);
  ASSERT_EQ(found.events.size(), 2u);
  EXPECT_NEAR(found.events[0].t, 2, 1e-12);
  EXPECT_NEAR(found.events[1].t, 3.5, 1e-12);
  EXPECT_EQ(found.stop, Stop::event);
  EXPECT_EQ(found.t, found.events[1].t);
}

TEST(Integrate, AZeroAtTheStartIsNoCrossing) {
  Goal goal;
  goal.events = {zero_of_x(true)};
  const Solution solution = adaptively("dopri5", oscillate, {0, 1}, 10, 1e-10, goal);
  EXPECT_EQ(solution.stop, Stop::event);
  EXPECT_NEAR(solution.t, std::numbers::pi, 1e-8);
  // Nor is the crossing that it begins from.
  const Solution next = adaptively("dopri5", oscillate, solution.y, 10, 1e-10, goal);
  EXPECT_NEAR(next.t, std::numbers::pi, 1e-8);
}

// What is interrupted in any way goes on to the same bits.
class Interrupted : public testing::TestWithParam<std::string> {
 protected:
  static constexpr double kEnd = 20;

  std::unique_ptr<Stepper> begin(const Checkpoint* from = nullptr) {
    const Method& method = method_named(GetParam());
    const Problem problem = problem_of(f_, {2, 0});
    std::optional<Adaptive> steps;
    if (method.is_adaptive()) steps = Adaptive{Tolerance({1e-6}, {1e-6}, 2), 0};
    if (from) return resumed_stepper(method, problem, *from, steps);
    return steps ? adaptive_stepper(method, problem, *steps) : equal_stepper(method, problem, kEnd / 777);
  }
  static Goal whole() {
    Goal goal;
    goal.t1 = kEnd;
    goal.times = even_times(0, kEnd, 41);
    goal.events = {zero_of_x()};
    return goal;
  }
  // Both parts together are the whole, bit for bit. The step that an end cut short was another one: what is
  // inside it agrees to the tolerance.
  static void expect_same(const Solution& first, const Solution& second, const Solution& all) {
    std::vector<double> rows = first.rows;
    rows.insert(rows.end(), second.rows.begin(), second.rows.end());
    ASSERT_EQ(rows.size(), all.rows.size());
    for (size_t i = 0; i < rows.size(); ++i) {
      const double t = all.rows[i / 3 * 3];
      const bool in_cut_step = first.stop == Stop::end && t > first.checkpoint.t && t <= first.t;
      EXPECT_NEAR(rows[i], all.rows[i], in_cut_step ? 1e-5 : 0) << "t = " << t;
    }
    EXPECT_EQ(second.y, all.y);
    const auto times = [](const Solution& solution) {
      std::vector<double> t;
      for (const Occurrence& event : solution.events) t.push_back(event.t);
      return t;
    };
    std::vector<double> parts = times(first);
    for (const double t : times(second)) parts.push_back(t);
    EXPECT_EQ(parts, times(all));
  }
  void expect_same_when(const std::function<void(Goal&)>& interrupt, Stop expected) {
    const Solution all = integrate(*begin(), whole());
    Goal goal = whole();
    interrupt(goal);
    const Solution first = integrate(*begin(), goal);
    ASSERT_EQ(first.stop, expected);
    goal = whole();
    goal.reported_t = first.checkpoint.reported_t;
    expect_same(first, integrate(*begin(&first.checkpoint), goal), all);
  }

  // A separable oscillator that is not linear.
  Function f_ = [](double, auto y, auto rate) { rate[0] = y[1], rate[1] = -std::sin(y[0]); };
};

INSTANTIATE_TEST_SUITE_P(, Interrupted,
                         testing::Values("rk4", "bs23", "dopri5", "dop853", "verner87", "verlet", "radau5"),
                         [](const auto& tested) { return tested.param; });

TEST_P(Interrupted, AfterSomeSteps) {
  expect_same_when([](Goal& goal) { goal.most_steps = 17; }, Stop::step_limit);
}

TEST_P(Interrupted, AtATimeInsideAStep) {
  expect_same_when([](Goal& goal) { goal.t1 = 7.7; }, Stop::end);
}

TEST_P(Interrupted, ByAnEvent) {
  expect_same_when([](Goal& goal) { goal.events[0].terminal = true; }, Stop::event);
}

// Where nobody looks at every step, many are taken at a time: they are the same.
TEST_P(Interrupted, ManyStepsAtATime) {
  for (const int64_t most : {int64_t{70}, std::numeric_limits<int64_t>::max()}) {
    Goal alone = whole(), together = whole();
    alone.most_steps = together.most_steps = most;
    alone.events = {{[](double, auto) { return 1.0; }}};  // looked at, and never zero
    together.events = {};
    const Solution expected = integrate(*begin(), alone), solution = integrate(*begin(), together);
    EXPECT_EQ(solution.stop, expected.stop);
    EXPECT_EQ(solution.steps, expected.steps);
    EXPECT_EQ(solution.t, expected.t);
    EXPECT_EQ(solution.y, expected.y);
    EXPECT_EQ(solution.rows, expected.rows);
    EXPECT_EQ(solution.checkpoint.t, expected.checkpoint.t);
  }
}

// The last of the equal steps is cut short, in both directions.
TEST(Integrate, EndsInsideAStep) {
  for (const double end : {1.0, -1.0}) {
    Function f = oscillate;
    const auto stepper = equal_stepper(method_named("rk4"), problem_of(f, {1, 0}), 0.03 * end);
    Goal goal;
    goal.t1 = end;
    goal.times = {end / 2, end};
    const Solution solution = integrate(*stepper, goal);
    EXPECT_EQ(solution.t, end);
    EXPECT_EQ(solution.steps, 34);
    EXPECT_NEAR(solution.y[0], std::cos(end), 1e-7);
    EXPECT_NEAR(solution.rows[1], std::cos(end / 2), 1e-7);
    EXPECT_EQ(solution.rows[4], solution.y[0]);
  }
}

TEST(Integrate, StopsAtLimits) {
  Goal goal;
  goal.most_time_s = 0;
  EXPECT_EQ(adaptively("dopri5", oscillate, {1, 0}, 1, 1e-6, goal).stop, Stop::time_limit);
  goal = {};
  goal.most_steps = 3;
  EXPECT_EQ(adaptively("dopri5", oscillate, {1, 0}, 1000, 1e-6, goal).steps, 3);
}

TEST(Integrate, IsCancelledWhenNobodyWaits) {
  Goal goal;
  int asked = 0;
  goal.go_on = [&](double, int64_t) { return ++asked < 3; };
  EXPECT_EQ(adaptively("bs23", oscillate, {1, 0}, 1e9, 1e-9, goal).stop, Stop::cancelled);
  EXPECT_EQ(asked, 3);
}

// y' = y², y = 1 / (1 − t): the pole at 1 lies inside.
TEST(Integrate, StopsAtAPole) {
  const Function square = [](double, auto y, auto rate) { rate[0] = y[0] * y[0]; };
  for (const char* method : {"dopri5", "dop853", "verner87", "radau5"}) {
    const Solution solution = adaptively(method, square, {1}, 2, 1e-9);
    EXPECT_EQ(solution.stop, Stop::step_too_small) << method;
    EXPECT_NEAR(solution.t, 1, 1e-6) << method;
  }
}

// Equal steps go many at a time; the last finite state is found all the same.
TEST(Integrate, EqualStepsStopBeforeWhatIsNotFinite) {
  const Function square = [](double, auto y, auto rate) { rate[0] = y[0] * y[0]; };
  for (const char* method : {"rk4", "verner87", "radau5"}) {
    const Solution together = in_equal_steps(method, square, {1}, 4, 400);
    Function f = square;
    const auto alone = equal_stepper(method_named(method), problem_of(f, {1}), 0.01);
    Stepper::Outcome outcome;
    while ((outcome = alone->step(4)) == Stepper::Outcome::stepped) {
    }
    EXPECT_EQ(together.stop,
              outcome == Stepper::Outcome::not_finite ? Stop::not_finite : Stop::step_too_small);
    EXPECT_GT(together.steps, 95) << method;
    EXPECT_LT(together.steps, 127) << method;  // inside the second 64
    EXPECT_EQ(together.steps, alone->steps()) << method;
    EXPECT_EQ(together.t, alone->t()) << method;
    EXPECT_EQ(together.y[0], alone->y()[0]) << method;
    EXPECT_TRUE(std::isfinite(together.y[0])) << method;
  }
}

// Inside many steps, at any stage: the stepper stands where it stood before them, and goes on from there.
TEST(Integrate, WhatTheRateThrowsLosesNoState) {
  const Stepper::Reach far = {10, 10, 50};
  Function whole = oscillate;
  const auto undisturbed = equal_stepper(method_named("rk4"), problem_of(whole, {1, 0}), 0.01);
  undisturbed->advance(far);
  const std::vector<double> y(undisturbed->y().begin(), undisturbed->y().end());
  undisturbed->advance(far);
  for (int last = 1; last <= 9; ++last) {
    int left = 50 * 4 + last;
    Function weak = [&](double t, auto state, auto rate) {
      if (left-- == 0) throw std::runtime_error("no more");
      oscillate(t, state, rate);
    };
    const auto stepper = equal_stepper(method_named("rk4"), problem_of(weak, {1, 0}), 0.01);
    stepper->advance(far);
    EXPECT_THROW(stepper->advance(far), std::runtime_error);
    EXPECT_EQ(stepper->t(), 0.5);
    EXPECT_EQ(std::vector(stepper->y().begin(), stepper->y().end()), y) << last;
    stepper->advance(far);
    EXPECT_EQ(std::vector(stepper->y().begin(), stepper->y().end()),
              std::vector(undisturbed->y().begin(), undisturbed->y().end()));
  }
}

TEST(Integrate, StopsWhereTheRateIsNotFinite) {
  const Function root = [](double, auto y, auto rate) { rate[0] = std::sqrt(y[0]); };
  const Solution solution = adaptively("dopri5", root, {-1}, 2, 1e-9);
  EXPECT_EQ(solution.stop, Stop::not_finite);
  EXPECT_EQ(solution.t, 0);
}

// Each component has its own tolerance: the one that is asked for nothing costs nothing.
TEST(Integrate, TolerancesAreOfEachComponent) {
  const Function two = [](double t, auto y, auto rate) {
    rate[0] = -y[0];
    rate[1] = std::cos(50 * t);
    rate[2] = 0;
    rate[3] = 0;
    rate[4] = 0;
  };
  const auto steps = [&](double of_the_fast_one) {
    Function f = two;
    std::vector<double> absolute(5, 1e-6);
    absolute[1] = of_the_fast_one;
    const auto stepper = adaptive_stepper(method_named("dopri5"), problem_of(f, {1, 0, 0, 0, 0}),
                                          {Tolerance(absolute, {0}, 5), 0});
    Goal goal;
    goal.t1 = 1;
    return integrate(*stepper, goal).steps;
  };
  EXPECT_LT(3 * steps(1e6), steps(1e-6));
}

TEST(EqualTimes, TakesTheFewestStepsThatAreShortEnough) {
  EXPECT_EQ(EqualTimes::count(0, 1, 0.1, 0), 10);
  EXPECT_EQ(EqualTimes::count(0, 1.1, 0.1, 0), 11);  // 1.1 / 0.1 is 11.000000000000002
  EXPECT_EQ(EqualTimes::count(0, 1, 0.3, 0), 4);
  EXPECT_EQ(EqualTimes::count(1, 0, 0.25, 0), 4);
  EXPECT_EQ(EqualTimes::count(0, 1, 0, 0), 1000);
  EXPECT_EQ(EqualTimes::count(0, 1, 0, 7), 1001);  // samples fall on ends of steps
  EXPECT_EQ(EqualTimes::count(0, 1, 0.5, 7), 7);
  EXPECT_EQ(EqualTimes::count(2, 2, 0.5, 0), 1);
}

TEST(EqualTimes, TellsHowManyStepsEndBefore) {
  const EqualTimes times{1, 0.1, 3};
  EXPECT_EQ(times.before(2, 100), 6);  // the tenth ends there
  EXPECT_EQ(times.before(1.95, 100), 6);
  EXPECT_EQ(times.before(2.0005, 100), 6);  // but for less than rounding leaves
  EXPECT_EQ(times.before(2.05, 100), 7);
  EXPECT_EQ(times.before(2, 2), 2);
  EXPECT_EQ(times.before(1, 100), 0);
  EXPECT_EQ((EqualTimes{1, -0.1, 3}.before(0, 100)), 6);
}

}  // namespace
}  // namespace animado::fred
