// The files of a run (docs/results.md): states.csv, frames.csv, events.jsonl, bodies.json, scene.animado,
// animation.glb and summary.json in one directory. Made of plain values, so that anything that moves bodies
// can write them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "controle/results/animation_glb.hpp"
#include "controle/results/bodies_json.hpp"
#include "controle/results/events_jsonl.hpp"
#include "controle/results/frames_csv.hpp"
#include "controle/results/states_csv.hpp"
#include "controle/results/summary_json.hpp"

namespace animado::controle {

struct ResultBody {
  std::string name = {};
  Shape shape = Sphere{1};
  Motion motion = Motion::dynamic;
  double mass_kg = 0;
  Vec3 color_srgb = Vec3::Constant(0.7);     // each in 0 … 1, as CSS means them
  RotationOrder rotation_order = {0, 1, 2};  // of its Euler angles in the table
};

std::vector<RecordedBody> recorded(const std::vector<ResultBody>& bodies);

class Results {
 public:
  // directory: where to write (ResultsDirectory::path while the run goes); it is there already.
  Results(std::filesystem::path directory, const std::vector<ResultBody>& bodies,
          std::string_view scene_text);

  // Has the animation hold the bodies' physics, too (physics_extensions.hpp). Before the first frame.
  void with_physics(std::vector<BodyPhysics> physics, std::string restitution_combine) {
    animation_.with_physics(std::move(physics), std::move(restitution_combine));
  }

  // The next frame, its events before it. state: shape (13, bodies), rows as in base/state.hpp.
  void frame(const FrameFacts& facts, std::span<const double> state);
  void event(const Event& event);
  int64_t frames() const { return frames_; }

  // Closes the tables, writes the animation and the summary, and makes sure that all of it is on the disk.
  // The number of frames is set here.
  void finish(Summary summary);

 private:
  std::filesystem::path directory_;
  StatesCsv states_;
  FramesCsv frames_table_;
  EventsJsonl events_;
  AnimationGlb animation_;
  int64_t frames_ = 0;
};

}  // namespace animado::controle
