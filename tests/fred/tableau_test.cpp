// src/fred/tableau.cpp: every method satisfies the order conditions of its order, up to 4, and no more than
// it claims.
#include "fred/tableau.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace animado::fred {
namespace {

class EveryMethod : public testing::TestWithParam<Tableau> {};

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(tableaus()),
                         [](const auto& tested) { return tested.param.name; });

double sum(size_t stages, const std::function<double(size_t)>& term) {
  double total = 0;
  for (size_t i = 0; i < stages; ++i) total += term(i);
  return total;
}

TEST_P(EveryMethod, IsExplicitAndItsNodesAreRowSums) {
  const Tableau& m = GetParam();
  ASSERT_EQ(m.weights.size(), m.stages());
  ASSERT_EQ(m.matrix.size(), m.stages() * m.stages());
  for (size_t i = 0; i < m.stages(); ++i) {
    EXPECT_NEAR(m.nodes[i], sum(m.stages(), [&](size_t j) { return m.matrix[i * m.stages() + j]; }), 1e-15);
    for (size_t j = i; j < m.stages(); ++j) EXPECT_EQ(m.matrix[i * m.stages() + j], 0);
  }
}

// The rooted trees of up to four vertices: Σ b_i φ_i = 1/γ for those of up to `order` vertices (Hairer,
// Nørsett, Wanner I, table II.2.1).
TEST_P(EveryMethod, SatisfiesTheConditionsOfItsOrderAndNotOfTheNext) {
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
      EXPECT_NEAR(value, expected, 1e-15) << vertices;
    }
    if (vertices == m.order + 1 && std::abs(value - expected) > 1e-3) next_fails = true;
  }
  EXPECT_TRUE(next_fails);
}

TEST(Tableau, IsFoundByNameWhateverTheCase) {
  EXPECT_EQ(tableau_named("RK4").name, "rk4");
}

TEST(Tableau, AnUnknownNameGetsTheNearest) {
  try {
    tableau_named("rk39");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unknown_name);
    EXPECT_NE(error.remedy().find("rk38"), std::string::npos) << error.remedy();
  }
}

}  // namespace
}  // namespace animado::fred
