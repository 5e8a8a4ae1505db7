// src/report/traffic.cpp: the step that is shown, and who said what in it.
#include "report/traffic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/temporary_directory.hpp"

namespace animado::report {
namespace {

using controle::Event;
using controle::EventKind;

// Logs as the modules write them; now_us is the clock that stamps their lines, and midnight comes at 1 s.
class TrafficTest : public testing::Test {
 protected:
  std::string stamp() const {
    const char* second = now_us < 1'000'000 ? "2026-11-21T23:59:59" : "2026-11-22T00:00:00";
    return fmt::format("{}.{:06}Z", second, now_us % 1'000'000);
  }
  void call(const char* to, const char* method, int took_us) {
    now_us += took_us;
    controle += fmt::format("{} info controle run/7#1 to {}: {} {}.0 µs\n", stamp(), to, method, took_us);
  }
  // colisao asks egesp while controle waits for colisao, which takes as long before and after.
  void respond(int took_us, int inner_us) {
    now_us += (took_us + inner_us) / 2;
    egesp += fmt::format("{} info egesp 7#2 solve matrices=(15,15,1) {}.0 µs ok\n", stamp(), inner_us);
    now_us -= (took_us + inner_us) / 2;
    call("colisao", "respond", took_us);
  }
  void end_step(int step, double time_s) {
    controle += fmt::format("{} info controle run/7#1 step {} ends at {} s\n", stamp(), step, time_s);
  }
  std::optional<Traffic> read(const std::vector<Event>& events = {}) {
    write_text(logs / "controle.log", controle);
    write_text(logs / "egesp.log", egesp);
    return read_traffic(logs, events);
  }
  static Event impact(double time_s) { return {.time_s = time_s, .kind = EventKind::impact}; }

  TemporaryDirectory logs;
  std::string controle, egesp;
  int now_us = 500'000;
};

TEST_F(TrafficTest, IsThatOfTheFirstStepWithAnImpact) {
  for (int step = 1; step <= 4; ++step) {
    call("egesp", "solve_prepared", 10);
    if (step >= 3) respond(100, 20);
    end_step(step, 0.1 * step);
  }
  const auto traffic = read({impact(0.25), impact(0.35)});
  ASSERT_TRUE(traffic);
  EXPECT_EQ(traffic->step, 3);
  EXPECT_NEAR(traffic->time_s, 0.3, 1e-12);
  EXPECT_NEAR(traffic->span_us, 110, 0.01);
}

TEST_F(TrafficTest, TellsWhoAskedWhom) {
  call("egesp", "solve_prepared", 10);
  respond(100, 20);
  end_step(1, 0.1);
  const auto traffic = read({impact(0.05)});
  ASSERT_TRUE(traffic);
  ASSERT_EQ(traffic->messages.size(), 3u);
  const Message &first = traffic->messages[0], &second = traffic->messages[1], &third = traffic->messages[2];
  EXPECT_EQ(first, (Message{first.at_us, 10, "controle", "egesp", "solve_prepared"}));
  EXPECT_EQ(second, (Message{second.at_us, 100, "controle", "colisao", "respond"}));
  EXPECT_EQ(third, (Message{third.at_us, 20, "colisao", "egesp", "solve"}));
  EXPECT_NEAR(first.at_us, 0, 0.01);
  EXPECT_NEAR(second.at_us, 10, 0.01);
  EXPECT_NEAR(third.at_us, 50, 0.01);
}

TEST_F(TrafficTest, WhatEgespDoesForControleIsNotColisaos) {
  call("egesp", "solve_prepared", 10);
  now_us += 2;  // clocks tell microseconds, and calls within one process take less
  egesp += fmt::format("{} info egesp 7#2 solve_prepared handle=1 1.0 µs ok\n", stamp());
  now_us -= 2;
  call("colisao", "sweep", 30);
  end_step(1, 0.1);
  const auto traffic = read();
  ASSERT_TRUE(traffic);
  EXPECT_EQ(traffic->messages.size(), 2u);
}

TEST_F(TrafficTest, WithoutImpactsIsThatOfTheSecondStep) {
  for (int step = 1; step <= 4; ++step) {
    call("fred", step == 1 ? "methods" : "stage", 10);
    end_step(step, 0.1 * step);
  }
  const auto traffic = read();
  ASSERT_TRUE(traffic);
  EXPECT_EQ(traffic->step, 2);
  EXPECT_EQ(traffic->messages.at(0).method, "stage");
}

TEST_F(TrafficTest, AnAnswerWithoutAnImpactIsNone) {
  respond(100, 20);
  end_step(1, 0.1);
  call("fred", "stage", 10);
  end_step(2, 0.2);
  EXPECT_EQ(read({impact(0.9)})->step, 2);
}

TEST_F(TrafficTest, AnImpactOfAnEarlierStepIsNotThisOnes) {
  call("fred", "stage", 10);
  end_step(1, 0.1);
  call("fred", "stage", 10);
  end_step(2, 0.2);
  respond(100, 20);
  end_step(3, 0.3);
  EXPECT_EQ(read({impact(0.05)})->step, 2);
}

TEST_F(TrafficTest, AStepThatIsTooLongToDrawIsPassedOver) {
  for (int step = 1; step <= 2; ++step) {
    for (int k = 0; k < (step == 1 ? 500 : 5); ++k) call("fred", "stage", 2);
    respond(10, 2);
    end_step(step, 0.1 * step);
  }
  EXPECT_EQ(read({impact(0.05), impact(0.15)})->step, 2);
}

TEST_F(TrafficTest, MidnightMayPass) {
  now_us = 999'990;
  call("egesp", "solve_prepared", 5);
  call("fred", "stage", 10);
  end_step(1, 0.1);
  const auto traffic = read();
  ASSERT_TRUE(traffic);
  EXPECT_NEAR(traffic->messages.at(1).at_us, 5, 0.01);
  EXPECT_NEAR(traffic->span_us, 15, 0.01);
}

TEST_F(TrafficTest, LogsWithoutStepsHaveNone) {
  call("fred", "stage", 10);
  EXPECT_FALSE(read());
  EXPECT_FALSE(read_traffic(logs / "nowhere", {}));
}

}  // namespace
}  // namespace animado::report
