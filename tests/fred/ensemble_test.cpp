// src/fred/ensemble.cpp: systems side by side move as each does alone.
#include "fred/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace animado::fred {
namespace {

// x'' = −w² x, each system with a w of its own.
double frequency(size_t system) {
  return 1 + 0.01 * static_cast<double>(system);
}

Ensemble oscillators(size_t systems) {
  Ensemble ensemble;
  ensemble.unknowns = 2;
  ensemble.y.resize(2 * systems);
  std::fill_n(ensemble.y.begin(), systems, 1.0);
  ensemble.derivative = [](double, size_t first, size_t count, const double* y, double* rate) {
    for (size_t i = 0; i < count; ++i) {
      const double w = frequency(first + i);
      rate[i] = y[count + i];
      rate[count + i] = -w * w * y[i];
    }
  };
  return ensemble;
}

class EnsembleByMethod : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, EnsembleByMethod, testing::Values("rk4", "dopri5", "dop853", "verner87", "verlet"),
                         [](const auto& tested) { return std::string(tested.param); });

// As many systems as fill two groups and a part of a third, which ends inside a register.
TEST_P(EnsembleByMethod, ASystemMovesAsItDoesAlone) {
  const Method& method = method_named(GetParam());
  const auto by_equal_steps = [&](const Problem& problem) {
    Problem separable = problem;
    separable.positions = [&] {
      std::vector<bool> positions(problem.y.size());
      std::fill_n(positions.begin(), positions.size() / 2, true);
      return positions;
    };
    return equal_stepper(method, separable, 0.05);
  };
  const size_t systems = 2 * group_size(method, 2) + 5;
  const EnsembleSolution all = integrate(method, oscillators(systems), 2, by_equal_steps);
  ASSERT_EQ(all.stop, Stop::end);
  for (size_t i = 0; i < systems; i += 7) {
    Ensemble one = oscillators(1);
    one.derivative = [&](double, size_t, size_t count, const double* y, double* rate) {
      ASSERT_EQ(count, 1u);
      rate[0] = y[1];
      rate[1] = -frequency(i) * frequency(i) * y[0];
    };
    const EnsembleSolution alone = integrate(method, one, 2, by_equal_steps);
    ASSERT_EQ(all.y[i], alone.y[0]) << i;
    ASSERT_EQ(all.y[systems + i], alone.y[1]) << i;
    EXPECT_NEAR(all.y[i], std::cos(2 * frequency(i)), 1) << "that they move at all";
  }
}

TEST(Ensemble, AdaptiveStepsKeepTheToleranceOfEachGroup) {
  const Method& method = method_named("dopri5");
  const size_t systems = 3 * group_size(method, 2);
  const EnsembleSolution all = integrate(method, oscillators(systems), 2, [&](const Problem& problem) {
    return adaptive_stepper(method, problem, {Tolerance({1e-10}, {1e-10}, problem.y.size()), 0});
  });
  for (size_t i = 0; i < systems; ++i) ASSERT_NEAR(all.y[i], std::cos(2 * frequency(i)), 1e-7) << i;
}

TEST(Ensemble, TheFirstGroupThatDoesNotReachTheEndIsNamedAndNoneSpoilsAnother) {
  const Method& method = method_named("rk4");
  const size_t size = group_size(method, 2), systems = 4 * size;
  Ensemble ensemble = oscillators(systems);
  const auto good = ensemble.derivative;
  ensemble.derivative = [&](double t, size_t first, size_t count, const double* y, double* rate) {
    good(t, first, count, y, rate);
    if (t > 1 && first == size) rate[3] = HUGE_VAL;
    if (t > 0.5 && first == 2 * size) rate[count - 1] = std::nan("");
  };
  const auto make = [&](const Problem& problem) { return equal_stepper(method, problem, 0.05); };
  const EnsembleSolution all = integrate(method, ensemble, 2, make);
  EXPECT_EQ(all.stop, Stop::not_finite);
  EXPECT_NEAR(all.t, 1, 0.051);
  EXPECT_EQ(all.first, size);
  EXPECT_EQ(all.count, size);
  const EnsembleSolution undisturbed = integrate(method, oscillators(systems), 2, make);
  for (size_t i = 0; i < systems; ++i) {
    if (i >= size && i < 3 * size) continue;
    ASSERT_EQ(all.y[i], undisturbed.y[i]) << i;
  }
}

TEST(Ensemble, GroupsFitTheFirstCache) {
  for (const char* name : {"euler", "rk4", "dopri5", "dop853"}) {
    for (size_t unknowns : {1, 7, 100}) {
      const size_t size = group_size(method_named(name), unknowns);
      EXPECT_EQ(size % 8, 0u);
      EXPECT_GE(size, 8u);
    }
  }
  EXPECT_EQ(group_size(method_named("rk4"), 7), 72u);  // 7 rows of 7 · 72 numbers: 28 KB
}

}  // namespace
}  // namespace animado::fred
