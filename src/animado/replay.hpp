// A run that was made before, to be made again with the edits that it took.
#pragma once

#include <filesystem>
#include <string>

namespace animado {

struct Replay {
  std::string scene;             // its file where it still has the text of then, else the copy in the results
  std::filesystem::path events;  // events.jsonl: the edits among them are made again
  std::string state_hash;        // of the end
  bool is_done;                  // went to the end of its time
};

struct ReplayOutcome {
  bool same;
  std::string text;  // a line for people
};

// Throws Error when the results are not there or are not whole.
Replay read_replay(const std::filesystem::path& directory);

// Whether the new results have the states of the old ones, to the last bit: of all frames where both runs are
// done, else as far as both went.
ReplayOutcome outcome_of(const Replay& replay, const std::filesystem::path& directory);

}  // namespace animado
