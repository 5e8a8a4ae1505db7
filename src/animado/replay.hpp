// A run that was made before, to be made again with the edits that it took.
#pragma once

#include <filesystem>
#include <string>

namespace animado {

struct Replay {
  std::string scene;             // its file where it still has the text of then, else the copy in the results
  std::filesystem::path events;  // events.jsonl: the edits among them are made again
  std::string state_hash;        // of the end
};

// Throws Error when the results are not there or are not whole.
Replay read_replay(const std::filesystem::path& directory);

// Whether the new results end as the old ones did, in a line for people.
std::string replay_report(const Replay& replay, const std::filesystem::path& directory);

}  // namespace animado
