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

Results::Results(std::filesystem::path directory, const std::vector<ResultBody>& bodies)
    : directory_(std::move(directory)),
      states_(directory_ / "states.csv", rows_of(bodies)),
      events_(directory_ / "events.jsonl"),
      animation_(nodes_of(bodies)) {}

void Results::frame(double time_s, std::span<const double> state) {
  states_.frame(frames_++, time_s, state);
  animation_.frame(time_s, state);
  events_.flush();
}

void Results::event(const Event& event) {
  events_.write(event);
}

void Results::finish(Summary summary) {
  summary.frames = frames_;
  states_.close();
  events_.close();
  animation_.write(directory_ / "animation.glb");
  write_summary(directory_ / "summary.json", summary);
}

}  // namespace animado::controle
