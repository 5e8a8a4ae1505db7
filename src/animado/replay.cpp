#include "animado/replay.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "console/terminal.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

nlohmann::json summary_in(const fs::path& directory) {
  const fs::path file = directory / "summary.json";
  std::ifstream in(file);
  const auto summary = nlohmann::json::parse(in, nullptr, false);
  const bool is_whole = summary.is_object() && summary.contains("state_hash") && summary.contains("scene");
  if (is_whole && fs::exists(directory / "states.csv")) return summary;
  throw Error(Code::unavailable, "there are no whole results here", directory.string(),
              "name the folder of a run, for example runs/colisao");
}

bool has_hash(const fs::path& file, const std::string& hash) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  Fnv1a of_text;
  of_text.add(std::string{std::istreambuf_iterator<char>(in), {}});
  return hex(of_text.value()) == hash;
}

bool is_done(const nlohmann::json& summary) {
  return summary.value("status", "") == "done";
}

// "frame 3, t = 0.1 s, `ball`", of a row of states.csv.
std::string place_of(const std::string& row) {
  std::istringstream cells(row);
  std::string frame, time_s, body;
  for (std::string* cell : {&frame, &time_s, &body}) std::getline(cells, *cell, ',');
  return fmt::format("frame {}, t = {} s, `{}`", frame, time_s, body);
}

// The place of the first row that two tables of states do not share, of those that both have; empty where
// they share all of them.
std::string first_difference(const fs::path& old_table, const fs::path& new_table) {
  std::ifstream old_rows(old_table), new_rows(new_table);
  std::string old_row, new_row;
  while (std::getline(old_rows, old_row) && std::getline(new_rows, new_row)) {
    if (new_row != old_row) return place_of(new_row);
  }
  return {};
}

}  // namespace

Replay read_replay(const fs::path& directory) {
  const auto summary = summary_in(directory);
  const std::string scene = summary.at("scene"), hash = summary.at("scene_hash");
  const std::string copy = directory / "scene.animado";
  return {has_hash(scene, hash) ? scene : copy, directory / "events.jsonl", summary.at("state_hash"),
          is_done(summary)};
}

ReplayOutcome outcome_of(const Replay& replay, const fs::path& directory) {
  const auto summary = summary_in(directory);
  const fs::path old = replay.events.parent_path();
  const auto differs = [&](const std::string& how) {
    return ReplayOutcome{false,
                         painted(fmt::format("NOT the same as {}{}\n", old.string(), how), Paint::red)};
  };
  if (const auto row = first_difference(old / "states.csv", directory / "states.csv"); !row.empty())
    return differs(" from here on: " + row);
  if (is_done(summary) && replay.is_done) {
    if (summary.at("state_hash") != replay.state_hash)
      return differs(", whose state hash is " + replay.state_hash);
    return {true, fmt::format("the same as {}, to the last bit\n", old.string())};
  }
  return {true, fmt::format("the same as {}, to the last bit, as far as both went\n", old.string())};
}

}  // namespace animado
