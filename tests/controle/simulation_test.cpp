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

TEST_P(Steps, StopWithinAFrame) {
  Simulation run =
      simulation("object ball\n shape sphere(radius=1)\n mass 2\n velocity (1, 0, 0)\n linear damping 1e5\n");
  int asked = 0;
  EXPECT_FALSE(run.stepper().advance_to(1, [&] { return ++asked > 3; }));
  EXPECT_GT(run.stepper().time_s(), 0);
  EXPECT_LT(run.stepper().time_s(), 1e-2);
  EXPECT_LE(run.stepper().counts().steps, 3);
}

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

class EqualSteps : public Steps {};

// Forces of many bodies are evaluated together.
TEST_P(EqualSteps, ABodyMovesToTheSameBitsAloneAndAmongOthersOfItsKind) {
  const auto object = [](int i) {
    return fmt::format(
        "object b{0}\n shape box(size=(1, 2, 3))\n mass {1}\n position ({2}, 0, 0)\n velocity (1, {0}, 0)\n"
        " angular velocity (0.1, 0.2, {0})\n force -0.1*mass*velocity\n force (sin(t), 0, 0)\n"
        " local force (0, orientation.qw, {0})\n torque -angular_velocity\n local torque (t, 0, 1)\n{3}",
        i, 1 + i % 3, 20 * i, i % 4 == 0 ? " linear damping 0.3\n angular damping 0.2\n" : "");
  };
  std::string all;
  for (int i = 0; i < 11; ++i) all += object(i);
  Simulation together = simulation(all);
  together.stepper().advance_to(0.01);
  for (const int i : {0, 5, 10}) {
    Simulation alone = simulation(object(i));
    alone.stepper().advance_to(0.01);
    const BodyState expected = body(alone, 0), actual = body(together, static_cast<size_t>(i));
    EXPECT_EQ(actual.pose.position_m, expected.pose.position_m) << i;
    EXPECT_EQ(actual.pose.orientation.coeffs(), expected.pose.orientation.coeffs()) << i;
    EXPECT_EQ(actual.velocity_m_s, expected.velocity_m_s) << i;
    EXPECT_EQ(actual.angular_velocity_body_rad_s, expected.angular_velocity_body_rad_s) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, EqualSteps,
                         testing::Values("method rk4\n substep 1/1000", "method dopri5\n substep 1/1000"),
                         [](const auto& tested) { return tested.index == 0 ? "rk4" : "dopri5"; });

// World axes and body axes, which a quarter turn about z tells apart.
TEST_P(EqualSteps, EveryKindOfForceActsAsWhatItIs) {
  Simulation run = simulation(
      "object ball\n shape sphere(radius=1)\n mass 1\n moments of inertia (1, 1, 1)\n rotation (0, 0, 90 "
      "deg)\n"
      " force (1, 0, 0)\n force (2, 0, 0)\n local force (0, 0, 4)\n local force (5, 0, 0)\n"
      " torque (6, 0, 0)\n local torque (7, 0, 0)\n");
  const double time_s = 1e-4;
  run.stepper().advance_to(time_s);
  const BodyState ball = body(run, 0);
  EXPECT_LT((ball.velocity_m_s / time_s - Vec3(3, 5, 4)).norm(), 1e-3);
  EXPECT_LT((ball.angular_velocity_rad_s() / time_s - Vec3(6, 7, 0)).norm(), 1e-3);
}

// A state that cannot be does not become the run's, nor what it would do to the energy.
TEST_P(EqualSteps, AMotionThatDivergesStaysWhereItWasFiniteAtLast) {
  for (const auto* push : {"force (1e200, 0, 0)", "torque (1e200, 0, 0)", "force (1e15, 0, 0)"}) {
    Simulation run = simulation(fmt::format("object ball\n shape sphere(radius=1)\n mass 1\n {}\n", push));
    try {
      run.stepper().advance_to(1);
      FAIL() << push;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::diverged) << error.what();
    }
    const BodyState ball = body(run, 0);
    EXPECT_LT(ball.velocity_m_s.norm(), 3e8) << push;
    EXPECT_LT(ball.angular_velocity_body_rad_s.norm(), 1e24) << push;
    EXPECT_TRUE(std::isfinite(run.stepper().flows().work_in_J)) << push;
  }
}

TEST_P(EqualSteps, APathThatIsNotFiniteIsRefusedAtItsPlace) {
  Simulation run =
      simulation("object ball\n shape sphere(radius=1)\n motion path\n path position (1/(t-0.2), 0, 0)\n");
  try {
    run.stepper().advance_to(0.3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::diverged);
    EXPECT_THAT(error.what(), testing::HasSubstr("the path of `ball` diverged at t = 0.2 s"));
    EXPECT_THAT(error.where(), testing::HasSubstr(":7:"));
  }
}

class Barrier : public Steps {};

// The force log(1 − x) holds back what comes at the edge of where it is a number, and long steps look beyond.
TEST_P(Barrier, AStepThatLooksBeyondWhatIsFiniteIsMadeShorter) {
  Simulation run = simulation(
      "object ball\n shape sphere(radius=1)\n mass 1\n velocity (44, 0, 0)\n force (1000*log(1 - "
      "position.x), "
      "0, 0)\n");
  const double start_J = 44.0 * 44 / 2;
  for (int frame = 1; frame <= 5; ++frame) run.stepper().advance_to(0.1 * frame);
  const BodyState ball = body(run, 0);
  const double left_m = 1 - ball.pose.position_m.x();
  const double potential_J = 1000 * (left_m * std::log(left_m) - left_m + 1);
  EXPECT_NEAR(ball.velocity_m_s.squaredNorm() / 2 + potential_J, start_J, 0.03 * start_J);
}

INSTANTIATE_TEST_SUITE_P(, Barrier,
                         testing::Values("method rk4\n tolerance 1e-4", "method dop853\n tolerance 1e-2"),
                         [](const auto& tested) { return tested.index == 0 ? "rk4" : "dop853"; });

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
