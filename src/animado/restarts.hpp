// Restarts belong to the story of a run: they stand among its events. The supervisor alone knows of them, so
// it puts them there when the run has ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace animado {

struct Restart {
  double time_s;  // of the last frame before it
  std::string service;
};

// Puts them into an events.jsonl, in the order of time. Throws Error(unavailable) when it cannot be read or
// written.
void add_restarts(const std::filesystem::path& events_file, const std::vector<Restart>& restarts);

}  // namespace animado
