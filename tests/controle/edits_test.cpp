#include "controle/edits.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::controle {
namespace {

Scene spring() {
  return parse_scene(R"(
spring.k = 4*ball.mass
object ball
  shape sphere(radius = 1)
  mass 2
  force (-spring.k*ball.position.x, 0, 0)
  force (0, 1, 0)
time
  end 1
  step 0.5
)");
}

}  // namespace

TEST(Edits, DefinitionsAreMassForceTorqueAndTheScenesNames) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"ball.mass", "2"},
      {"ball.force", "(((-spring.k*ball.position.x, 0, 0)) + ((0, 1, 0)))"},
      {"ball.torque", "(0, 0, 0)"},
      {"spring.k", "4*ball.mass"}};
  const auto definitions = definitions_of(spring());
  ASSERT_EQ(definitions.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(definitions[i].first, expected[i].first);
  EXPECT_EQ(definitions[3].second, expected[3].second);
}

TEST(Edits, AnEditedForceStandsForAllItsLines) {
  const Scene scene = edited(spring(), "ball.force", "(0, -1, 0)");
  ASSERT_EQ(scene.bodies[0].forces.size(), 1u);
  EXPECT_EQ(scene.bodies[0].forces[0].text, "(0, -1, 0)");
  EXPECT_EQ(edited(spring(), "spring.k", "9").names[0].value.text, "9");
  EXPECT_EQ(edited(spring(), "wind.speed", "3").names.size(), 2u);
}

TEST(Edits, AMassCannotChangeWhileTheRunGoes) {
  EXPECT_THROW(edited(spring(), "ball.mass", "3"), Error);
}

}  // namespace animado::controle
