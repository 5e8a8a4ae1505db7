// src/controle/results/summary_json.cpp
#include "controle/results/summary_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

using Json = nlohmann::ordered_json;

Summary example() {
  Summary summary;
  summary.scene = "scenes/colisao.animado";
  summary.scene_hash = 0x2a;
  summary.frames = 12, summary.bodies = 2, summary.steps = 34, summary.impacts = 1;
  summary.energy = {.initial_J = 3, .final_J = 1.5, .work_in_J = 0.25, .dissipated_impacts_J = 1.75};
  summary.momentum_initial.linear_kg_m_s = {0, 0.1, 0};
  summary.momentum_final.angular_kg_m2_s = {1, 2, 3};
  summary.state_hash = 0xfedcba9876543210u;
  summary.wall_time_s = 0.125;
  summary.time_per_module_s = {{"interexpserv", 0.5}, {"egesp", 0.25}};
  summary.messages_per_module = {{"interexpserv", 7}, {"egesp", 136}};
  return summary;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(SummaryJson, KeysAreTheContractInAFixedOrder) {
  const Json page = Json::parse(summary_text(example()));
  EXPECT_EQ(keys_of(page),
            (std::vector<std::string>{"scene", "scene_hash", "version", "status", "frames", "bodies", "steps",
                                      "impacts", "energy", "momentum", "state_hash", "wall_time_s",
                                      "time_per_module", "messages_per_module", "units"}));
  EXPECT_EQ(keys_of(page["energy"]),
            (std::vector<std::string>{"initial", "final", "work_in", "dissipated_impacts",
                                      "dissipated_friction", "dissipated_damping", "residual"}));
  EXPECT_EQ(keys_of(page["messages_per_module"]), (std::vector<std::string>{"interexpserv", "egesp"}));
}

TEST(SummaryJson, SaysWhatItWasGiven) {
  const Json page = Json::parse(summary_text(example()));
  EXPECT_EQ(page["scene"], "scenes/colisao.animado");
  EXPECT_EQ(page["scene_hash"], "000000000000002a");
  EXPECT_EQ(page["version"], ANIMADO_VERSION);
  EXPECT_EQ(page["frames"], 12);
  EXPECT_EQ(page["bodies"], 2);
  EXPECT_EQ(page["steps"], 34);
  EXPECT_EQ(page["impacts"], 1);
  EXPECT_EQ(page["energy"]["initial"], 3.0);
  EXPECT_EQ(page["energy"]["dissipated_impacts"], 1.75);
  EXPECT_EQ(page["energy"]["residual"], 0.0);
  EXPECT_EQ(page["momentum"]["initial"]["linear"], Json({0.0, 0.1, 0.0}));
  EXPECT_EQ(page["momentum"]["final"]["angular"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(page["state_hash"], "fedcba9876543210");
  EXPECT_EQ(page["wall_time_s"], 0.125);
  EXPECT_EQ(page["time_per_module"]["egesp"], 0.25);
  EXPECT_EQ(page["messages_per_module"]["egesp"], 136);
}

TEST(SummaryJson, StatusTellsHowTheRunEnded) {
  Summary summary = example();
  EXPECT_EQ(Json::parse(summary_text(summary))["status"], "done");
  summary.status = RunStatus::interrupted;
  EXPECT_EQ(Json::parse(summary_text(summary))["status"], "interrupted");
  summary.status = RunStatus::diverged;
  EXPECT_EQ(Json::parse(summary_text(summary))["status"], "diverged");
}

TEST(SummaryJson, NumbersReadBackToTheSameBits) {
  Summary summary = example();
  summary.energy = {.initial_J = 1.0 / 3, .final_J = 0.1 + 0.2};
  const Json energy = Json::parse(summary_text(summary))["energy"];
  EXPECT_EQ(energy["initial"].get<double>(), 1.0 / 3);
  EXPECT_EQ(energy["final"].get<double>(), 0.1 + 0.2);
}

TEST(SummaryJson, IsWrittenForPeopleToo) {
  const TemporaryDirectory directory;
  write_summary(directory.path() / "summary.json", example());
  const std::string text = text_of(directory.path() / "summary.json");
  EXPECT_EQ(text, summary_text(example()));
  EXPECT_TRUE(text.starts_with("{\n  \"scene\": \"scenes/colisao.animado\",\n")) << text;
  EXPECT_TRUE(text.ends_with("}\n"));
}

}  // namespace
}  // namespace animado::controle
