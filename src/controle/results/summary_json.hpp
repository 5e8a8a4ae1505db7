// summary.json: a run in one page. The same scene gives the same summary but for the times.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/spatial.hpp"
#include "controle/results/ledger.hpp"

namespace animado::controle {

enum class RunStatus { done, interrupted, diverged };

inline constexpr std::array<std::string_view, 3> kRunStatuses = {"done", "interrupted", "diverged"};

struct Momentum {
  Vec3 linear_kg_m_s = Vec3::Zero();
  Vec3 angular_kg_m2_s = Vec3::Zero();  // about the world's origin
};

struct Summary {
  std::string scene = {};   // its path, as it was given
  uint64_t scene_hash = 0;  // Fnv1a of the scene's text
  RunStatus status = RunStatus::done;
  int64_t frames = 0, bodies = 0, steps = 0, impacts = 0;
  EnergyLedger energy = {};
  Momentum momentum_initial = {}, momentum_final = {};
  uint64_t state_hash = 0;  // Fnv1a of the final state's numbers, shape (13, bodies)
  double wall_time_s = 0;
  std::vector<std::pair<std::string, double>> time_per_module_s =
      {};  // in the order in which they are to be listed
  std::vector<std::pair<std::string, int64_t>> messages_per_module = {};
};

std::string summary_text(const Summary& summary);  // pretty printed, keys in a fixed order
void write_summary(const std::filesystem::path& file, const Summary& summary);

}  // namespace animado::controle
