// src/interexpserv/scope.cpp: whose `mass` is meant.
#include "interexpserv/scope.hpp"

#include <gtest/gtest.h>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

MapScope two_objects() {
  MapScope scope;
  scope.set("ball.mass", Value::scalar(2)).set("cube.mass", Value::scalar(5)).set("mass", Value::scalar(100));
  scope.set("gravity", Value::scalar(10)).set("cube.gravity", Value::scalar(-1));
  scope.define("ball.weight", "mass*gravity", "ball").define("Cube.Weight", "mass*gravity", "Cube");
  return scope;
}

double in(const Scope& scope, std::string_view text) {
  return compile(text, scope).constant().v[0];
}

TEST(Scope, AnObjectsOwnNamesComeFirst) {
  const MapScope scope = two_objects();
  EXPECT_EQ(in(scope, "mass"), 100);
  EXPECT_EQ(in(HomeScope(scope, "ball"), "mass"), 2);
  EXPECT_EQ(in(HomeScope(scope, "Cube"), "mass"), 5);
  EXPECT_EQ(in(HomeScope(scope, "ball"), "cube.mass"), 5);
  EXPECT_EQ(in(HomeScope(scope, "ball"), "ball.mass"), 2);
}

// Seen from the cube, ball.weight still means the ball's mass and the world's gravity, not the cube's.
TEST(Scope, ADefinitionIsReadInItsOwnHome) {
  const MapScope scope = two_objects();
  EXPECT_EQ(in(HomeScope(scope, "cube"), "ball.weight"), 20);
  EXPECT_EQ(in(HomeScope(scope, "ball"), "weight"), 20);
  EXPECT_EQ(in(HomeScope(scope, "ball"), "cube.weight"), -5);
  EXPECT_EQ(in(scope, "ball.weight + cube.weight"), 15);
}

TEST(Scope, KnownNamesIncludeTheShortOnes) {
  const MapScope scope = two_objects();
  const std::vector<std::string> names = HomeScope(scope, "ball").known_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "ball.weight"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "weight"), names.end());
}

}  // namespace
}  // namespace animado::interexpserv
