// src/fred/tableau.cpp: every method satisfies the order conditions of its order, up to 4, and no more than
// it claims.
#include "fred/tableau.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fred/embedded.hpp"

namespace animado::fred {
namespace {

class EveryTableau : public testing::TestWithParam<Tableau> {};

INSTANTIATE_TEST_SUITE_P(, EveryTableau, testing::ValuesIn(tableaus()),
                         [](const auto& tested) { return tested.param.name; });

double sum(size_t stages, const std::function<double(size_t)>& term) {
  double total = 0;
  for (size_t i = 0; i < stages; ++i) total += term(i);
  return total;
}

// Large weights of both signs cancel: beyond a sum of 10 what they lose to rounding is larger by as much.
double cancellation(const Tableau& m) {
  return std::max(1.0, sum(m.stages(), [&](size_t i) { return std::abs(m.weights[i]); }) / 10);
}

TEST_P(EveryTableau, IsExplicitAndItsNodesAreRowSums) {
  const Tableau& m = GetParam();
  ASSERT_EQ(m.weights.size(), m.stages());
  ASSERT_EQ(m.matrix.size(), m.stages() * m.stages());
  for (size_t i = 0; i < m.stages(); ++i) {
    EXPECT_NEAR(m.nodes[i], sum(m.stages(), [&](size_t j) { return m.matrix[i * m.stages() + j]; }), 1e-14);
    for (size_t j = i; j < m.stages(); ++j) EXPECT_EQ(m.matrix[i * m.stages() + j], 0);
  }
}

// Where the rounding of h a_j would show, h stays outside of the sum.
TEST_P(EveryTableau, StagesOfSmallCoefficientsTakeTheStep) {
  const Tableau& m = GetParam();
  for (size_t s = 1; s < m.derivatives(); ++s) {
    const auto row = m.coefficients(s);
    const double size = sum(row.size(), [&](size_t j) { return std::abs(row[j]); });
    EXPECT_EQ(m.places[s].sum.takes_step, s != m.stages() && size < 32) << "stage " << s;
  }
}

// The rooted trees of up to four vertices: Σ b_i φ_i = 1/γ for those of up to `order` vertices (Hairer,
// Nørsett, Wanner I, table II.2.1).
TEST_P(EveryTableau, SatisfiesTheConditionsOfItsOrderAndNotOfTheNext) {
  const Tableau& m = GetParam();
  const auto c = [&](size_t i) { return m.nodes[i]; };
  const auto a = [&](size_t i, const std::function<double(size_t)>& f) {
    return sum(i, [&](size_t j) { return m.matrix[i * m.stages() + j] * f(j); });
  };
  const auto square = [&](size_t i) { return c(i) * c(i); };
  struct Condition {
    int vertices;
    double expected;
    std::function<double(size_t)> phi;
  };
  const std::vector<Condition> conditions = {
      {1, 1. / 1, [](size_t) { return 1.0; }},
      {2, 1. / 2, c},
      {3, 1. / 3, square},
      {3, 1. / 6, [&](size_t i) { return a(i, c); }},
      {4, 1. / 4, [&](size_t i) { return c(i) * square(i); }},
      {4, 1. / 8, [&](size_t i) { return c(i) * a(i, c); }},
      {4, 1. / 12, [&](size_t i) { return a(i, square); }},
      {4, 1. / 24, [&](size_t i) { return a(i, [&](size_t j) { return a(j, c); }); }},
  };
  bool next_fails = m.order >= 4;
  for (const auto& [vertices, expected, phi] : conditions) {
    const double value = sum(m.stages(), [&](size_t i) { return m.weights[i] * phi(i); });
    if (vertices <= m.order) {
      EXPECT_NEAR(value, expected, 2e-15 * cancellation(m)) << vertices;
    }
    if (vertices == m.order + 1 && std::abs(value - expected) > 1e-3) next_fails = true;
  }
  EXPECT_TRUE(next_fails);
}

// Each estimate's weights are the difference of two methods: they sum to zero, and the embedded one satisfies
// the quadrature conditions up to its order.
TEST_P(EveryTableau, EstimatesAreDifferencesOfMethods) {
  const Tableau& m = GetParam();
  for (size_t k = 0; k < m.errors.size(); ++k) {
    ASSERT_EQ(m.errors[k].size(), m.stages() + 1);
    const int order = m.errors.size() == 1 ? m.error_order : k == 0 ? 5 : 3;
    for (int power = 0; power < order; ++power) {
      const double value = sum(m.stages() + 1, [&](size_t i) {
        return m.errors[k][i] * std::pow(i < m.stages() ? m.nodes[i] : 1, power);
      });
      EXPECT_NEAR(value, 0, 1e-14) << power;
    }
  }
}

// u(θ) for y' = t^(q−1) is θ^q: the quadrature conditions of the dense output.
TEST_P(EveryTableau, DenseOutputIsExactForPolynomials) {
  const Tableau& m = GetParam();
  for (const double theta : {0.0, 0.1, 0.37, 0.5, 0.99, 1.0}) {
    const DenseWeights weights = dense_weights(m, theta);
    for (int power = 1; power <= std::min(m.order, m.dense_order); ++power) {
      const auto rate = [&](size_t i) { return power * std::pow(m.node(i), power - 1); };
      const double end = sum(m.stages(), [&](size_t i) { return m.weights[i] * rate(i); });
      const double inside = weights.difference * end +
                            sum(m.derivatives(), [&](size_t i) { return weights.rates[i] * rate(i); });
      EXPECT_NEAR(inside, std::pow(theta, power), 1e-13 * cancellation(m)) << power << " at " << theta;
    }
  }
}

}  // namespace
}  // namespace animado::fred
