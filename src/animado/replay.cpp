#include "animado/replay.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

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
  if (summary.is_object() && summary.contains("state_hash") && summary.contains("scene")) return summary;
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

}  // namespace

Replay read_replay(const fs::path& directory) {
  const auto summary = summary_in(directory);
  const std::string scene = summary.at("scene"), hash = summary.at("scene_hash");
  const std::string copy = directory / "scene.animado";
  return {has_hash(scene, hash) ? scene : copy, directory / "events.jsonl", summary.at("state_hash")};
}

std::string replay_report(const Replay& replay, const fs::path& directory) {
  const std::string hash = summary_in(directory).at("state_hash");
  const std::string of = replay.events.parent_path().string();
  if (hash == replay.state_hash) return fmt::format("the same as {}, to the last bit\n", of);
  return painted(fmt::format("NOT the same as {}, whose state hash is {}\n", of, replay.state_hash),
                 Paint::red);
}

}  // namespace animado
