// A run read back from its results folder, for whoever shows it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/spatial.hpp"
#include "controle/results/bodies_json.hpp"
#include "controle/results/events_jsonl.hpp"
#include "controle/results/frames_csv.hpp"

namespace animado::controle {

struct RecordedState {  // a row of states.csv; world
  Pose pose;
  Vec3 euler_rad = Vec3::Zero();
  Vec3 velocity_m_s = Vec3::Zero();
  Vec3 angular_velocity_rad_s = Vec3::Zero();
};

struct RecordedRun {
  std::vector<RecordedBody> bodies = {};
  std::vector<double> times_s = {};        // of the frames
  std::vector<RecordedState> states = {};  // (frames, bodies)
  std::vector<FrameFacts> facts = {};      // a frame
  std::vector<Event> events = {};
  std::string summary_json = {}, scene_text = {};

  size_t frames() const { return times_s.size(); }
  const RecordedState& at(size_t frame, size_t body) const { return states[frame * bodies.size() + body]; }
};

// Both throw Error with file:line and remedy when a file is missing or is not what a run writes.
RecordedRun read_run(const std::filesystem::path& directory);
std::vector<Event> read_events(const std::filesystem::path& file);  // events.jsonl

std::vector<Event> edits_of(std::vector<Event> events);

}  // namespace animado::controle
