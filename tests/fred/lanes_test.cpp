// src/fred/lanes.cpp: the bits of the sums in their stated order, whatever the width of a register.
#include "fred/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fred/tableau.hpp"

namespace animado::fred {
namespace {

std::vector<const LaneKernels*> kernels_of_this_machine() {
  std::vector<const LaneKernels*> all = {&kLanesOne, &kLanesSse2};
  if (__builtin_cpu_supports("avx2")) all.push_back(&kLanesAvx2);
  if (__builtin_cpu_supports("avx512f")) all.push_back(&kLanesAvx512);
  return all;
}

constexpr size_t kSize = 24;

// Rows of numbers that differ in all their bits, and sums over them that begin with the last.
class Lanes : public testing::TestWithParam<int> {
 protected:
  Lanes() {
    for (size_t r = 0; r < kMostTerms + 2; ++r) {
      for (size_t i = 0; i < kSize; ++i) rows_[r][i] = std::sin(static_cast<double>(7 * r + 3 * i) + 0.1);
    }
    for (size_t j = 0; j < kMostTerms; ++j) k_[j] = rows_[j];
    for (int which = 0; which < kMostEstimates; ++which) {
      sums_[which].count = GetParam();
      for (int j = 0; j < GetParam(); ++j) {
        sums_[which].rows[j] = static_cast<unsigned char>(kMostTerms - 1 - j);
        sums_[which].coefficients[j] = std::cos(j + 0.3 + which);
      }
    }
  }
  double sum(int which, size_t i, double factor = 1) const {
    const Sum& s = sums_[which];
    double total = factor * s.coefficients[0] * k_[s.rows[0]][i];
    for (int j = 1; j < s.count; ++j) total += factor * s.coefficients[j] * k_[s.rows[j]][i];
    return total;
  }

  double rows_[kMostTerms + 2][kSize];
  const double *k_[kMostTerms], *y_ = rows_[kMostTerms], *end_ = rows_[kMostTerms + 1];
  Sum sums_[kMostEstimates];
};

INSTANTIATE_TEST_SUITE_P(Terms, Lanes, testing::Range(1, kMostTerms + 1));

TEST_P(Lanes, Combine) {
  const auto terms = static_cast<size_t>(GetParam());
  for (const LaneKernels* kernels : kernels_of_this_machine()) {
    std::vector<double> out(kSize, 9);
    kernels->combine[terms](y_, k_, sums_[0], 0.1, out.data(), 4, 20);
    for (size_t i = 0; i < kSize; ++i) {
      EXPECT_EQ(out[i], i < 4 || i >= 20 ? 9 : y_[i] + 0.1 * sum(0, i)) << kernels->width << " " << i;
    }
    Sum with_step = sums_[0];
    with_step.takes_step = true;
    kernels->combine[terms](y_, k_, with_step, 0.1, out.data(), 0, kSize);
    for (size_t i = 0; i < kSize; ++i)
      EXPECT_EQ(out[i], y_[i] + sum(0, i, 0.1)) << kernels->width << " " << i;
  }
}

// y' of each element from itself and the time alone.
void rate(void* evaluations, double t, const double* y, double* rate, size_t size) {
  ++*static_cast<int*>(evaluations);
  for (size_t i = 0; i < size; ++i) rate[i] = 0.3 * t - y[i] * (1 + 0.1 * y[i]);
}

// The end of a step from (t, y): the tableau's sums one after the other, element by element.
std::vector<double> step(const Tableau& method, double t, double h, const std::vector<double>& y) {
  std::vector<std::vector<double>> k(method.stages(), y);
  int evaluations = 0;
  rate(&evaluations, t, y.data(), k[0].data(), y.size());
  std::vector<double> stage = y;
  for (size_t s = 1; s <= method.stages(); ++s) {
    const auto& [sum, node] = method.places[s];
    const double inside = sum.takes_step ? h : 1, outside = sum.takes_step ? 1 : h;
    for (size_t i = 0; i < y.size(); ++i) {
      double total = inside * sum.coefficients[0] * k[sum.rows[0]][i];
      for (int j = 1; j < sum.count; ++j) total += inside * sum.coefficients[j] * k[sum.rows[j]][i];
      stage[i] = y[i] + outside * total;
    }
    if (s < method.stages()) rate(&evaluations, t + node * h, stage.data(), k[s].data(), y.size());
  }
  return stage;
}

class LaneSteps : public testing::TestWithParam<Tableau> {
 protected:
  static constexpr double kOrigin = 0.7, kStep = 0.11;
  static constexpr int64_t kFirst = 3;
  static constexpr size_t kUnknowns = 13, kRow = 16;

  // The two states after `count` steps from `start`.
  struct Ends {
    alignas(64) double states[2][kRow] = {};
    int evaluations = 0;
  };
  static Ends run(const LaneKernels& kernels, const std::vector<double>& start, int64_t count) {
    Ends ends;
    alignas(64) double rates[kMostDerivatives][kRow] = {}, stage[kRow] = {};
    double* rows[kMostDerivatives];
    for (size_t s = 0; s < kMostDerivatives; ++s) rows[s] = rates[s];
    auto& [y, end] = ends.states;
    std::ranges::copy(start, y);
    rate(&ends.evaluations, kOrigin + static_cast<double>(kFirst) * kStep, y, rows[0], kUnknowns);
    kernels.steps[GetParam().number](
        {{&ends.evaluations, rate}, kOrigin, kStep, kFirst, count, y, end, rows, stage, kUnknowns, kRow});
    return ends;
  }
};

INSTANTIATE_TEST_SUITE_P(, LaneSteps, testing::ValuesIn(tableaus()),
                         [](const auto& tested) { return tested.param.name; });

// Bit for bit; an odd and an even number of steps, which end in one or the other of the two states.
TEST_P(LaneSteps, AreTheSumsOfTheTableau) {
  std::vector<double> start(kUnknowns);
  for (size_t i = 0; i < kUnknowns; ++i) start[i] = std::sin(static_cast<double>(i) + 0.4);
  std::vector<double> y = start;
  for (int64_t count = 1; count <= 4; ++count) {
    const double t = kOrigin + static_cast<double>(kFirst + count - 1) * kStep;
    const std::vector<double> before = std::exchange(y, step(GetParam(), t, kStep, y));
    for (const LaneKernels* kernels : kernels_of_this_machine()) {
      const Ends ends = run(*kernels, start, count);
      EXPECT_EQ(ends.evaluations, count * static_cast<int64_t>(GetParam().stages()));
      for (size_t i = 0; i < kUnknowns; ++i) {
        ASSERT_EQ(ends.states[count % 2][i], y[i]) << kernels->width << " element " << i << " step " << count;
        ASSERT_EQ(ends.states[1 - count % 2][i], before[i]);
      }
    }
  }
}

TEST_P(Lanes, SquareErrors) {
  const auto terms = static_cast<size_t>(GetParam());
  std::vector<double> absolute(kSize), relative(kSize);
  for (size_t i = 0; i < kSize; ++i) {
    absolute[i] = 1e-3 + 1e-5 * static_cast<double>(i);
    relative[i] = 1e-2 / static_cast<double>(i + 1);
  }
  for (const size_t stride : {0, 1}) {
    const ErrorScale scale = {absolute.data(), relative.data(), stride};
    double expected[kMostEstimates][kRunningSums] = {{1, 2, 3, 4}, {5, 6, 7, 8}};
    for (size_t i = 4; i < 20; ++i) {
      const double largest = std::max(std::abs(y_[i]), std::abs(end_[i]));
      const double unit = absolute[i * stride] + relative[i * stride] * largest;
      for (int which = 0; which < kMostEstimates; ++which) {
        const double error = sum(which, i) * (1 / unit);
        expected[which][i % kRunningSums] += error * error;
      }
    }
    for (const LaneKernels* kernels : kernels_of_this_machine()) {
      if (kernels == &kLanesAvx512) continue;  // has none
      for (size_t estimates = 1; estimates <= kMostEstimates; ++estimates) {
        double running[kMostEstimates][kRunningSums] = {{1, 2, 3, 4}, {5, 6, 7, 8}};
        kernels->square_errors[estimates][terms](y_, end_, k_, sums_, scale, running, 4, 20);
        for (size_t which = 0; which < estimates; ++which) {
          for (size_t i = 0; i < kRunningSums; ++i) EXPECT_EQ(running[which][i], expected[which][i]);
        }
      }
    }
  }
}

// One element that is not finite is found wherever it is.
TEST(Lanes, FindWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const LaneKernels* kernels : kernels_of_this_machine()) {
    std::vector<double> v(kSize, std::numeric_limits<double>::max());
    EXPECT_TRUE(kernels->are_finite(v.data(), 0, kSize));
    for (const double bad : {infinity, -infinity, std::nan("")}) {
      for (size_t i = 0; i < kSize; ++i) {
        const double good = std::exchange(v[i], bad);
        EXPECT_FALSE(kernels->are_finite(v.data(), 0, kSize)) << kernels->width << " " << i;
        v[i] = good;
      }
    }
  }
}

}  // namespace
}  // namespace animado::fred
