// src/controle/results/results.cpp
#include "controle/results/results.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/state.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

const std::vector<ResultBody> kTwoBodies = {
    {.name = "esfera", .shape = Sphere{1}},
    {.name = "cubo", .shape = Box{{0.5, 0.5, 0.5}}, .rotation_order = {2, 1, 0}}};

std::vector<double> state_at_rest() {
  std::vector<double> state(2 * kStateRows);
  for (size_t i = 0; i < 2; ++i) store_body(state.data(), 2, i, BodyState{});
  return state;
}

TEST(Results, WritesTheFilesOfTheContract) {
  const TemporaryDirectory directory;
  Results results(directory.path(), kTwoBodies, "# a scene\n");
  results.frame({.time_s = 0}, state_at_rest());
  results.event({.time_s = 0.1, .kind = EventKind::impact, .bodies = {"esfera", "cubo"}});
  results.frame({.time_s = 0.3}, state_at_rest());
  results.finish({.scene = "colisao.animado", .bodies = 2});

  const std::string states = text_of(directory.path() / "states.csv");
  EXPECT_EQ(std::count(states.begin(), states.end(), '\n'), 5);
  EXPECT_NE(states.find("\n1,0.29999999999999999,cubo,"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(directory.path() / "events.jsonl"))["time_s"], 0.1);
  EXPECT_TRUE(text_of(directory.path() / "animation.glb").starts_with("glTF"));
  const auto summary = nlohmann::json::parse(text_of(directory.path() / "summary.json"));
  EXPECT_EQ(summary["frames"], 2);
  EXPECT_EQ(summary["status"], "done");
}

TEST(Results, EventsAreReadableWhileTheRunGoes) {
  const TemporaryDirectory directory;
  Results results(directory.path(), kTwoBodies, "# a scene\n");
  results.event({.time_s = 0.1, .kind = EventKind::impact});
  results.frame({.time_s = 0.3}, state_at_rest());
  EXPECT_NE(text_of(directory.path() / "events.jsonl").find("impact"), std::string::npos);
}

TEST(Results, AMissingDirectoryIsAnError) {
  EXPECT_THROW(Results("/no/such/directory", kTwoBodies, ""), Error);
}

}  // namespace
}  // namespace animado::controle
