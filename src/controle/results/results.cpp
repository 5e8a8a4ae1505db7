#include "controle/results/results.hpp"

#include <utility>

namespace animado::controle {
namespace {

std::vector<StatesCsv::Body> rows_of(const std::vector<ResultBody>& bodies) {
  std::vector<StatesCsv::Body> rows;
  for (const ResultBody& body : bodies) rows.push_back({body.name, body.rotation_order});
  return rows;
}

std::vector<AnimatedBody> nodes_of(const std::vector<ResultBody>& bodies) {
  std::vector<AnimatedBody> nodes;
  for (const ResultBody& body : bodies)
    nodes.push_back({body.name, body.shape, body.motion, body.color_srgb});
  return nodes;
}

}  // namespace

std::vector<RecordedBody> recorded(const std::vector<ResultBody>& bodies) {
  std::vector<RecordedBody> all;
  for (const ResultBody& body : bodies)
    all.push_back({body.name, body.motion, body.mass_kg, body.color_srgb, body.shape});
  return all;
}

Results::Results(std::filesystem::path directory, const std::vector<ResultBody>& bodies,
                 std::string_view scene_text)
    : directory_(std::move(directory)),
      states_(directory_ / "states.csv", rows_of(bodies)),
      frames_table_(directory_ / "frames.csv"),
      events_(directory_ / "events.jsonl"),
      animation_(nodes_of(bodies)) {
  write_whole(directory_ / "bodies.json", bodies_text(recorded(bodies)));
  write_whole(directory_ / "scene.animado", scene_text);
}

void Results::frame(const FrameFacts& facts, std::span<const double> state) {
  states_.frame(frames_, facts.time_s, state);
  frames_table_.frame(frames_++, facts);
  animation_.frame(facts.time_s, state);
  states_.flush();
  frames_table_.flush();
  events_.flush();
}

void Results::event(const Event& event) {
  events_.write(event);
}

void Results::finish(Summary summary) {
  summary.frames = frames_;
  states_.close();
  frames_table_.close();
  events_.close();
  animation_.write(directory_ / "animation.glb");
  write_summary(directory_ / "summary.json", summary);
}

}  // namespace animado::controle
