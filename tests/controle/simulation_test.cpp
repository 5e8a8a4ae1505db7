// src/controle/simulation.cpp and what it is made of, with the services in this process.
#include "controle/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animado/in_process.hpp"
#include "base/error.hpp"
#include "controle/edits.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {
namespace {

class Steps : public testing::TestWithParam<const char*> {
 protected:
  Simulation simulation(const std::string& objects) {
    return {parse_scene(fmt::format("world\n {}\n{}\ntime\n end 1\n step 0.1\n", GetParam(), objects)),
            *suite_, fmt::format("test/{}", ++runs_), log_, [](const Event&) {}};
  }
  static BodyState body(Simulation& simulation, size_t i) {
    return load_body(simulation.stepper().state(), simulation.scene().bodies.size(), i);
  }

  std::unique_ptr<rpc::Suite> suite_ = suite_in_process();
  rpc::Log log_;
  int runs_ = 0;
};

// What the old force was at the end of the last step is not where the next one starts.
TEST_P(Steps, AnEditedForceActsFromItsFrameOn) {
  Simulation run = simulation("object ball\n shape sphere(radius=1)\n mass 2\n force (20, 0, 0)\n");
  run.stepper().advance_to(0.1);
  EXPECT_NEAR(body(run, 0).velocity_m_s.x(), 1, 1e-14);
  run.edit(edited(run.scene(), "ball.force", "(0, 40, 0)"));
  run.stepper().advance_to(0.2);
  EXPECT_NEAR(body(run, 0).velocity_m_s.x(), 1, 1e-14);
  EXPECT_NEAR(body(run, 0).velocity_m_s.y(), 2, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(, Steps, testing::Values("method rk4", "method dopri5", "method dop853"),
                         [](const auto& tested) { return std::string(tested.param).substr(7); });

class Singular : public Steps {};

// From rest at 1 m, 1/r² reaches the origin at π/(2√2) s, with a speed without bound.
TEST_P(Singular, AFallIntoAPoleEndsWithAnExplanation) {
  Simulation run = simulation(
      "object ball\n shape sphere(radius=1)\n mass 1\n position (1, 0, 0)\n force "
      "-position/norm(position)^3\n");
  try {
    run.stepper().advance_to(2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::diverged);
    EXPECT_THAT(error.message(), testing::HasSubstr("at t = 1.1107207"));
    EXPECT_THAT(error.remedy(), testing::HasSubstr("1/r^2"));
  }
}

INSTANTIATE_TEST_SUITE_P(, Singular,
                         testing::Values("method dopri5\n tolerance 1e-9", "method dop853\n tolerance 1e-9"),
                         [](const auto& tested) { return std::string(tested.param).substr(7, 6); });

}  // namespace
}  // namespace animado::controle
