// Runs a scene as a user would, and reads what it left. Every experiment is made twice: with five processes
// over sockets, and with everything in one process.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/spatial.hpp"

namespace animado::experiments {

struct Row {  // of states.csv
  int frame = 0;
  double time_s = 0;
  std::string body;
  Vec3 position_m, euler_rad, velocity_m_s, angular_velocity_rad_s;  // world
  Quat orientation;
};

struct Record {
  std::vector<Row> rows;
  std::vector<nlohmann::json> events;
  nlohmann::json summary;

  std::vector<Row> of(const std::string& body) const;
  std::vector<nlohmann::json> impacts() const;
};

enum class Way { sockets, in_process };

// Simulates a scene's text and returns what it left; fails the test when the run fails.
Record simulate(const std::string& scene, Way way);
Record simulate_file(const std::string& path, Way way);

// An experiment made both ways: TEST_P(FreeFall, …) with `way()`.
class Experiment : public testing::TestWithParam<Way> {
 protected:
  Record simulate(const std::string& scene) const { return experiments::simulate(scene, GetParam()); }
};

std::string name_of(const testing::TestParamInfo<Way>& info);

#define ANIMADO_BOTH_WAYS(suite)                                                                           \
  INSTANTIATE_TEST_SUITE_P(                                                                                \
      , suite, testing::Values(animado::experiments::Way::sockets, animado::experiments::Way::in_process), \
      animado::experiments::name_of)

}  // namespace animado::experiments
