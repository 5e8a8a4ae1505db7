// What a page is told of a run that goes on, made of the files that the run writes: logs, events, frames.
#pragma once

#include <deque>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "controle/results/frames_csv.hpp"
#include "live/growing_file.hpp"

namespace animado::live {

class Feed {
 public:
  // directory: the run's, while it goes.
  Feed(const std::filesystem::path& directory, size_t bodies);

  using Json = nlohmann::json;
  using Messages = std::vector<Json>;

  // Messages (web/README.md) of what is new since the last call.
  Messages take();

 private:
  void take_logs(Messages& messages);
  void take_events(Messages& messages);
  void take_frames(Messages& messages);
  void read_facts();
  void read_states();

  struct Poses {
    Json positions_m = Json::array(), rotations = Json::array();
    size_t bodies = 0;
  };

  size_t bodies_;
  GrowingFile states_, facts_, events_;
  std::vector<std::pair<std::string, GrowingFile>> logs_;  // by module
  bool states_begun_ = false, facts_begun_ = false;        // their headers were read
  std::deque<Poses> poses_;                                // the last may still grow
  std::deque<controle::FrameFacts> frame_facts_;           // of the same frames, as far as they are there
  int64_t frame_ = 0;
};

}  // namespace animado::live
