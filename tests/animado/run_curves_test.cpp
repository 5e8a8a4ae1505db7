// src/animado/run_curves.cpp
#include "animado/run_curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace animado {
namespace {

using testing::ElementsAre;

// Two frames of two bodies.
controle::RecordedRun example_run() {
  controle::RecordedRun run;
  run.bodies = {{.name = "Bola"}, {.name = "floor", .motion = Motion::fixed}};
  run.times_s = {0, 0.5};
  run.states.resize(4);
  run.states[0].pose.position_m = {1, 2, 3};
  run.states[2].pose.position_m = {4, 5, 6};
  run.states[2].velocity_m_s = {3, 4, 0};
  run.facts.resize(2);
  run.facts[1].step_s = 0.25;
  run.facts[1].kinetic_J = 7;
  run.facts[1].potential_J = 1;
  run.facts[1].dissipated_impacts_J = 2;
  run.facts[1].dissipated_friction_J = 3;
  run.facts[1].angular_kg_m2_s = {0, 0, 9};
  return run;
}

std::vector<std::string> names_in(const Panel& panel) {
  std::vector<std::string> names;
  for (const Curve& curve : panel.curves) names.push_back(curve.name);
  return names;
}

TEST(RunCurves, ABodysAreInPanelsByQuantity) {
  const RunCurves curves = curves_of(example_run(), {"bola.y", "Bola.speed", "bola.x"});
  ASSERT_EQ(curves.panels.size(), 2u);
  EXPECT_EQ(label_of(curves.panels[0]), "position (m)");
  EXPECT_THAT(names_in(curves.panels[0]), ElementsAre("Bola.y", "Bola.x"));
  EXPECT_THAT(curves.panels[0].curves[0].y, ElementsAre(2, 5));
  EXPECT_EQ(label_of(curves.panels[1]), "velocity (m/s)");
  EXPECT_THAT(curves.panels[1].curves[0].y, ElementsAre(0, 5));
}

TEST(RunCurves, EnergyLeavesOutWhatIsNotThere) {
  const RunCurves curves = curves_of(example_run(), {"energy"});
  ASSERT_EQ(curves.panels.size(), 1u);
  EXPECT_EQ(label_of(curves.panels[0]), "energy (J)");
  EXPECT_THAT(names_in(curves.panels[0]), ElementsAre("total", "kinetic", "potential", "lost"));
  EXPECT_THAT(curves.panels[0].curves[0].y, ElementsAre(0, 8));
  EXPECT_THAT(curves.panels[0].curves[3].y, ElementsAre(0, 5));
}

TEST(RunCurves, MomentumIsOfTwoKinds) {
  const RunCurves curves = curves_of(example_run(), {"momentum"});
  ASSERT_EQ(curves.panels.size(), 2u);
  EXPECT_THAT(names_in(curves.panels[1]), ElementsAre("Lx", "Ly", "Lz"));
  EXPECT_THAT(curves.panels[1].curves[2].y, ElementsAre(0, 9));
}

TEST(RunCurves, NoStepLeadsToTheFirstFrame) {
  const RunCurves curves = curves_of(example_run(), {"step", "contacts"});
  EXPECT_TRUE(std::isnan(curves.panels[0].curves[0].y[0]));
  EXPECT_EQ(curves.panels[0].curves[0].y[1], 0.25);
  EXPECT_EQ(label_of(curves.panels[1]), "contact points");
}

TEST(RunCurves, AreATable) {
  EXPECT_EQ(csv_of(curves_of(example_run(), {"bola.y", "bola.vx"})),
            "time_s,Bola.y,Bola.vx\n0,2,0\n0.5,5,3\n");
}

TEST(RunCurves, RefusesAnUnknownNameAndNamesTheNearest) {
  try {
    curves_of(example_run(), {"enrgy"});
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unknown_name);
    EXPECT_THAT(error.remedy(), testing::HasSubstr("'energy'"));
  }
  EXPECT_THROW(curves_of(example_run(), {"bola.q"}), Error);
  EXPECT_THROW(curves_of(example_run(), {"nobody.x"}), Error);
}

}  // namespace
}  // namespace animado
