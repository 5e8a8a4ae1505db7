// src/controle/pushes.cpp, program_batch.cpp: many bodies with one formula, to the bits of each alone.
#include "controle/pushes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controle/preparation.hpp"

namespace animado::controle {
namespace {

constexpr size_t kBodies = 37;  // no whole number of lanes

// A body a line: its formula is that of its number among `forces`.
Scene scene_of(const std::vector<std::string>& forces) {
  std::string text = "object sun\n shape sphere(radius=1)\n motion static\n position (0, -3, 1)\n";
  for (size_t i = 0; i < kBodies; ++i) {
    text += fmt::format("object b{}\n shape sphere(radius=0.1)\n mass {}\n position ({}, 0, 0)\n force {}\n",
                        i, 2 + i % 5, i, forces[i % forces.size()]);
  }
  return parse_scene(text + "time\n end 1\n step 0.1\n");
}

// Any state will do whose numbers all differ.
std::vector<double> some_state(size_t bodies) {
  std::vector<double> state(kStateRows * bodies);
  for (size_t k = 0; k < state.size(); ++k) state[k] = std::sin(1 + 3.7 * static_cast<double>(k));
  return state;
}

std::vector<LiveProgram> programs_of(const Scene& scene) {
  const SceneScope scope(scene);
  std::vector<LiveProgram> programs;
  for (const Body& body : scene.bodies) {
    for (const Expression& force : body.forces) programs.emplace_back(scope, force);
  }
  return programs;
}

void expect_the_bits_of_each_alone(const std::vector<std::string>& forces) {
  const Scene scene = scene_of(forces);
  const std::vector<LiveProgram> programs = programs_of(scene);
  const std::vector<Drive> all = drives(scene, SceneScope(scene));
  Pushes pushes(all);
  const size_t n = scene.bodies.size();
  std::vector<double> state = some_state(n), out(6 * n);
  for (const double time_s : {0.25, 0.5}) {
    const Moment moment{state.data(), n, time_s};
    pushes.evaluate(moment, out.data());
    for (size_t i = 0; i < programs.size(); ++i) {
      const size_t body = 1 + i;  // after the sun
      EXPECT_EQ(Vec3(out[body], out[n + body], out[2 * n + body]), programs[i].vector(moment)) << i;
    }
    std::ranges::reverse(state);  // nothing of one moment is left in the next
  }
}

TEST(Pushes, HaveTheBitsOfEachBodyAlone) {
  for (const char* force :
       {"(0, -9.81*mass, 0) - 0.1*velocity", "-0.3*norm(velocity)*velocity + (sin(t), exp(-t), 0)",
        "cross(angular_velocity, velocity) * orientation.qw",
        "mass * (sun.position - position) / norm(sun.position - position)^3", "(1, 2, 3)",
        "(b3.position.x, position.y > 0 ? 1 : -1, t)"}) {
    SCOPED_TRACE(force);
    expect_the_bits_of_each_alone({force});
  }
}

TEST(Pushes, TellFormulasApart) {
  expect_the_bits_of_each_alone({"-0.1*velocity", "-0.1*position", "velocity*3", "velocity/3",
                                 "b0.position - position", "(0, 1, 0) - 0.1*velocity", "b1.velocity"});
}

TEST(Pushes, MoreFormulasThanAreLookedAt) {
  std::vector<std::string> forces;
  for (int i = 0; i < 20; ++i) {
    std::string force = "velocity";
    for (int k = 0; k < i; ++k) force += " + position*norm(velocity)^" + std::to_string(k + 2);
    forces.push_back(force);
  }
  expect_the_bits_of_each_alone(forces);
}

// The second body's first formula is met after the others, and comes first all the same: three numbers have
// another last digit in another order.
TEST(Pushes, AreAddedInTheOrderOfTheirLines) {
  const std::string later = " force 0.2*position\n force 0.3*position\n";
  const Scene scene = parse_scene("object a\n shape sphere(radius=1)\n mass 1\n force velocity\n" + later +
                                  "object b\n shape sphere(radius=1)\n mass 1\n position (9, 0, 0)\n force "
                                  "0.1*norm(position)*position\n" +
                                  later + "time\n end 1\n step 0.1\n");
  const std::vector<LiveProgram> programs = programs_of(scene);
  const std::vector<Drive> all = drives(scene, SceneScope(scene));
  Pushes pushes(all);
  std::vector<double> state = some_state(2), out(12);
  int told_apart = 0;
  for (int turn = 0; turn < 13; ++turn) {
    const Moment moment{state.data(), 2, 0};
    pushes.evaluate(moment, out.data());
    const Vec3 first = programs[3].vector(moment), second = programs[4].vector(moment),
               third = programs[5].vector(moment);
    EXPECT_EQ(Vec3(out[1], out[3], out[5]), Vec3(first + second + third));
    told_apart += Vec3(first + second + third) != Vec3(second + third + first);
    std::ranges::rotate(state, state.begin() + 1);
  }
  EXPECT_GT(told_apart, 0);
}

TEST(ProgramBatch, TakesWhatDiffersInBodiesAndMasses) {
  const std::vector<LiveProgram> programs =
      programs_of(scene_of({"-mass*position", "-mass*position", "-7*position", "-mass*velocity",
                            "-mass*position/2", "-t*position", "position/7"}));
  ProgramBatch batch(programs[0]);
  EXPECT_TRUE(batch.add(programs[1]));
  EXPECT_TRUE(batch.add(programs[2]));
  EXPECT_FALSE(batch.add(programs[3]));  // other inputs
  EXPECT_FALSE(batch.add(programs[4]));  // other operations
  EXPECT_FALSE(batch.add(programs[5]));
  EXPECT_FALSE(batch.add(programs[6]));
  EXPECT_EQ(batch.lanes(), 3u);
}

}  // namespace
}  // namespace animado::controle
