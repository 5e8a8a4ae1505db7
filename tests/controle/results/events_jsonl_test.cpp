// src/controle/results/events_jsonl.cpp
#include "controle/results/events_jsonl.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

using nlohmann::json;

Event impact() {
  Event event{.time_s = 1.1419538200000001, .kind = EventKind::impact, .bodies = {"esfera", "cubo"}};
  event.point_m = Vec3(0, 1.0 / 3, 0.1);
  event.normal = Vec3(0, 1, 0);
  event.impulse_N_s = Vec3(0, 2.5, -1e-17);
  event.approach_m_s = 1.2;
  event.separation_m_s = 0.6;
  return event;
}

TEST(EventsJsonl, AnImpactIsOneLineOfJson) {
  const std::string line = event_line(impact());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const json object = json::parse(line);
  EXPECT_EQ(object["time_s"].get<double>(), 1.1419538200000001);
  EXPECT_EQ(object["kind"], "impact");
  EXPECT_EQ(object["bodies"], json({"esfera", "cubo"}));
  EXPECT_EQ(object["point_m"].get<std::vector<double>>(), (std::vector<double>{0, 1.0 / 3, 0.1}));
  EXPECT_EQ(object["normal"].get<std::vector<double>>(), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(object["impulse_N_s"].get<std::vector<double>>(), (std::vector<double>{0, 2.5, -1e-17}));
  EXPECT_EQ(object["approach_m_s"].get<double>(), 1.2);
  EXPECT_EQ(object["separation_m_s"].get<double>(), 0.6);
}

TEST(EventsJsonl, WhatDoesNotApplyIsLeftOut) {
  const json object = json::parse(event_line({.time_s = 2, .kind = EventKind::restart, .name = "egesp"}));
  EXPECT_EQ(object, json::parse(R"({"time_s": 2, "kind": "restart", "bodies": [], "name": "egesp"})"));
}

TEST(EventsJsonl, AnEditKeepsItsExpression) {
  const std::string expression = "(0, \"é\", -9.81*mass)\n";
  const Event edit{
      .time_s = 0.5, .kind = EventKind::edit, .bodies = {"ball"}, .name = "ball.force", .value = expression};
  const std::string line = event_line(edit);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(json::parse(line)["value"], expression);
}

TEST(EventsJsonl, KindsAreSpelledAsInTheContract) {
  const std::vector<std::string> names = {"impact", "contact_begin", "contact_end", "edit", "restart"};
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(json::parse(event_line({.kind = static_cast<EventKind>(i)}))["kind"], names[i]);
  }
}

TEST(EventsJsonlDeathTest, NotANumberIsABug) {
  EXPECT_DEATH(event_line({.approach_m_s = std::numeric_limits<double>::quiet_NaN()}), "isfinite");
}

TEST(EventsJsonl, ALineAnEvent) {
  const TemporaryDirectory directory;
  EventsJsonl events(directory.path() / "events.jsonl");
  events.write(impact());
  events.write(impact());
  events.close();
  const std::string line = event_line(impact()) + "\n";
  EXPECT_EQ(text_of(directory.path() / "events.jsonl"), line + line);
}

}  // namespace
}  // namespace animado::controle
