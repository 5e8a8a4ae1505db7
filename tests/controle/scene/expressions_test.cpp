// src/controle/scene/scope.cpp, state_names.cpp: what names mean in forces, torques and paths.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "controle/scene/scope.hpp"

namespace animado::controle {
namespace {

using interexpserv::Program;
using interexpserv::Type;

Scene scene_for_a_second(const std::string& text) {
  return parse_scene(text + "\ntime\n end 1\n step 0.1\n");
}

// The value of the program for a body turned by `q`, at t = 2; its only inputs.
Vec3 value(const SceneScope& scope, const Program& program, const Quat& q) {
  std::vector<double> inputs;
  for (const auto& input : program.inputs()) {
    const Member member = scope.state_names().find(input.name)->member;
    inputs.push_back(member == Member::time ? 2
                     : member == Member::qw ? q.w()
                     : member == Member::qx ? q.x()
                     : member == Member::qy ? q.y()
                                            : q.z());
  }
  Vec3 v;
  program.evaluate(inputs.data(), v.data());
  return v;
}

TEST(SceneScope, ForceIsTheSumOfItsLinesInTheWorld) {
  const Scene scene = scene_for_a_second(
      "object ball\n mass 3\n force (0, -9.81*mass, 0)\n force (t, 0, 0)\n local force (0, 0, 5)\n torque "
      "cross((1,0,0), force)");
  const SceneScope scope(scene);
  const Quat q = Quat(0.5, 0.1, -0.7, 0.2).normalized();
  const Program force = scope.compile({"ball.force", {}, -1}, Type::vector);
  EXPECT_NEAR((value(scope, force, q) - (Vec3(2, -29.43, 0) + q * Vec3(0, 0, 5))).norm(), 0, 1e-14);
}

TEST(SceneScope, PrefixMayBeLeftOutInTheOwnBlock) {
  const Scene scene = scene_for_a_second("object ball\n mass 3\nobject cube\n mass 5");
  const SceneScope scope(scene);
  EXPECT_EQ(scope.compile({"mass", {}, 0}).constant().v[0], 3);
  EXPECT_EQ(scope.compile({"mass", {}, 1}).constant().v[0], 5);
  EXPECT_EQ(scope.compile({"Ball.Mass", {}, 1}).constant().v[0], 3);
  EXPECT_THROW(scope.compile({"mass", {}, -1}), Error);
}

TEST(SceneScope, DefinitionsReadTheBlockTheyStandIn) {
  const Scene scene = scene_for_a_second(
      "object ball\n mass 3\n pull.down = -9.81 * mass\nobject cube\n mass 5\n force (0, pull.down, 0)");
  const SceneScope scope(scene);
  EXPECT_DOUBLE_EQ(scope.compile(scene.bodies[1].forces[0], Type::vector).constant().v[1], -29.43);
}

TEST(SceneScope, FunctionsAndUnitsOfTheScene) {
  const Scene scene = scene_for_a_second(
      "f(x, y) = x^2 + mix.weight(y)\nobject ball\n mass 300 g\n mix.weight(z) = z*mass\n position (10 cm, "
      "0, 2 km)\n"
      " force (0, f(2, 10), 0)");
  EXPECT_EQ(scene.bodies[0].mass_kg, 0.3);
  EXPECT_EQ(scene.bodies[0].position_m, Vec3(0.1, 0, 2000));
  const SceneScope scope(scene);
  EXPECT_DOUBLE_EQ(scope.compile(scene.bodies[0].forces[0], Type::vector).constant().v[1], 7);
  EXPECT_THROW(scene_for_a_second("f(x) = f(x - 1)\nobject ball\n mass 1"), Error);
  EXPECT_THROW(scene_for_a_second("sin(x) = x\nobject ball\n mass 1"), Error);
  EXPECT_THROW(scene_for_a_second("object ball\n mass 1\n position (1 m + 2 s, 0, 0)"), Error);
}

TEST(SceneScope, DefinitionsMeanTheSameOutsideTheirBlock) {
  const Scene scene = scene_for_a_second(
      "object ball\n mass 3\n pull.k = 2\n pull.down = (Mass + sin(position.x) * pull.k) * velocity - "
      "ball.position");
  EXPECT_EQ(scene.names[1].value.text,
            "(ball.Mass + sin(ball.position.x) * pull.k) * ball.velocity - ball.position");
  EXPECT_EQ(scene.names[1].value.owner, -1);
}

TEST(SceneScope, ChangesOfTheSceneAreSeenByTheNextCompile) {
  Scene scene = scene_for_a_second("object ball\n mass 3\n force (1, 0, 0)");
  const SceneScope scope(scene);
  scene.bodies[0].forces = {{"(0, 2, 0)", {}, 0}};
  EXPECT_EQ(scope.compile({"ball.force.y", {}, -1}).constant().v[0], 2);
}

TEST(StateNames, HoldTheNamespaceOfEveryObject) {
  const StateNames names({"ball", "cube"});
  EXPECT_EQ(names.find("cube.orientation.qx"), (Reading{Member::qx, 1}));
  EXPECT_EQ(names.find("t"), (Reading{Member::time, -1}));
  EXPECT_FALSE(names.find("cube.orientation"));
  EXPECT_FALSE(names.find("ball"));
  EXPECT_THAT(names.known_names(), testing::Contains("ball.angular_velocity"));
}

}  // namespace
}  // namespace animado::controle
