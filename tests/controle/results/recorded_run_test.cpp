// src/controle/results/recorded_run.cpp: what a run writes is read back as it was.
#include "controle/results/recorded_run.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "base/state.hpp"
#include "controle/results/results.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

const Hull kTetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                           {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

const std::vector<ResultBody> kBodies = {
    {.name = "ball", .shape = Sphere{0.1}, .mass_kg = 2, .color_srgb = {1, 0.5, 0}},
    {.name = "crate", .shape = Box{{0.5, 1, 1.5}}},
    {.name = "pill", .shape = Capsule{0.25, 0.5}},
    {.name = "can", .shape = Cylinder{0.25, 0.5}},
    {.name = "hat", .shape = Cone{0.25, 0.5}},
    {.name = "rock", .shape = kTetrahedron, .motion = Motion::kinematic},
    {.name = "floor", .shape = HalfSpace{{0, 1, 0}, -2}, .motion = Motion::fixed}};

std::vector<double> state(double shift_m) {
  std::vector<double> numbers(kBodies.size() * kStateRows);
  for (size_t i = 0; i < kBodies.size(); ++i) {
    BodyState body;
    body.pose.position_m = {shift_m, 0.1 * static_cast<double>(i), -1 / 3.0};
    body.pose.orientation = Quat(0.6, 0, 0.8, 0);
    body.velocity_m_s = {0, 1e-300, 7};
    store_body(numbers.data(), kBodies.size(), i, body);
  }
  return numbers;
}

class RecordedRunTest : public testing::Test {
 protected:
  RecordedRunTest() {
    Results results(directory_.path(), kBodies, "# seven solids\n");
    results.frame({.time_s = 0, .kinetic_J = 0.1}, state(0));
    results.event({.time_s = 0.1,
                   .kind = EventKind::impact,
                   .bodies = {"ball", "crate"},
                   .point_m = Vec3(1, 2, 3),
                   .approach_m_s = 0.7});
    results.event({.time_s = 0.2, .kind = EventKind::edit, .name = "ball.force", .value = "(0, \"1\", 0)"});
    results.frame({.time_s = 0.3,
                   .step_s = 0.01,
                   .steps = 30,
                   .impacts = 1,
                   .contacts = 4,
                   .dissipated_impacts_J = 26.5,
                   .residual_J = -3e-15,
                   .angular_kg_m2_s = {1, 2, 3}},
                  state(0.1));
    results.finish({.scene = "seven.animado"});
  }
  void append(const char* file, const char* text) {
    std::ofstream(directory_.path() / file, std::ios::app) << text;
  }
  RecordedRun read() { return read_run(directory_.path()); }

  TemporaryDirectory directory_;
};

TEST_F(RecordedRunTest, HasTheStatesToTheBit) {
  const RecordedRun run = read();
  ASSERT_EQ(run.frames(), 2);
  EXPECT_EQ(run.times_s, (std::vector{0, 0.3}));
  EXPECT_EQ(run.at(1, 2).pose.position_m, Vec3(0.1, 0.2, -1 / 3.0));
  EXPECT_EQ(run.at(1, 2).pose.orientation.w(), 0.6);
  EXPECT_EQ(run.at(0, 6).velocity_m_s, Vec3(0, 1e-300, 7));
}

TEST_F(RecordedRunTest, HasTheBodies) {
  const RecordedRun run = read();
  ASSERT_EQ(run.bodies.size(), kBodies.size());
  EXPECT_EQ(run.bodies[0].name, "ball");
  EXPECT_EQ(run.bodies[0].mass_kg, 2);
  EXPECT_EQ(run.bodies[0].color_srgb, Vec3(1, 0.5, 0));
  EXPECT_EQ(run.bodies[5].motion, Motion::kinematic);
  EXPECT_EQ(run.bodies[6].motion, Motion::fixed);
  for (size_t i = 0; i < kBodies.size(); ++i)
    EXPECT_EQ(run.bodies[i].shape.index(), kBodies[i].shape.index());
  EXPECT_EQ(std::get<Box>(run.bodies[1].shape).half_m, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(std::get<Capsule>(run.bodies[2].shape).half_height_m, 0.5);
  EXPECT_EQ(std::get<Cone>(run.bodies[4].shape).height_m, 0.5);
  EXPECT_EQ(std::get<Hull>(run.bodies[5].shape).faces, kTetrahedron.faces);
  EXPECT_EQ(std::get<HalfSpace>(run.bodies[6].shape).offset_m, -2);
}

TEST_F(RecordedRunTest, HasTheFacts) {
  const RecordedRun run = read();
  ASSERT_EQ(run.facts.size(), 2);
  EXPECT_EQ(run.facts[0].kinetic_J, 0.1);
  EXPECT_EQ(run.facts[1].time_s, 0.3);
  EXPECT_EQ(numbers_of(run.facts[1]), numbers_of({.step_s = 0.01,
                                                  .steps = 30,
                                                  .impacts = 1,
                                                  .contacts = 4,
                                                  .dissipated_impacts_J = 26.5,
                                                  .residual_J = -3e-15,
                                                  .angular_kg_m2_s = {1, 2, 3}}));
}

TEST_F(RecordedRunTest, HasTheEventsAndTheTexts) {
  const RecordedRun run = read();
  ASSERT_EQ(run.events.size(), 2);
  EXPECT_EQ(run.events[0].point_m, Vec3(1, 2, 3));
  EXPECT_EQ(run.events[0].approach_m_s, 0.7);
  EXPECT_FALSE(run.events[0].normal);
  EXPECT_EQ(run.events[1].value, "(0, \"1\", 0)");
  EXPECT_EQ(run.scene_text, "# seven solids\n");
  EXPECT_NE(run.summary_json.find("seven.animado"), std::string::npos);
}

TEST_F(RecordedRunTest, AFrameThatWasNotEndedIsNotThere) {
  append("states.csv", "2,0.6,ball,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0\n");
  EXPECT_EQ(read().frames(), 2);
}

TEST_F(RecordedRunTest, WhatIsBrokenIsToldWithItsPlace) {
  append("frames.csv", "2,0.6,what\n");
  append("states.csv", "2,0.6,ball,0,zero\n");
  try {
    read();
    FAIL() << "a word was read as a number";
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "'zero' where a number is expected");
    EXPECT_NE(error.where().find("states.csv:16"), std::string::npos) << error.where();
  }
}

TEST_F(RecordedRunTest, AFolderWithoutResultsIsToldApart) {
  std::filesystem::remove(directory_.path() / "states.csv");
  try {
    read();
    FAIL() << "nothing was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_NE(error.remedy().find("runs/colisao"), std::string::npos);
  }
}

TEST(Bodies, AHullNamesVerticesThatAreThere) {
  const std::string text =
      R"({"bodies": [{"name": "a", "motion": "dynamic", "mass_kg": 1, "color": [0, 0, 0],)"
      R"( "shape": {"kind": "hull", "vertices_m": [[0, 0, 0]], "faces": [[0, 1, 2]]}}]})";
  EXPECT_THROW(parse_bodies(text, "bodies.json"), Error);
}

}  // namespace
}  // namespace animado::controle
