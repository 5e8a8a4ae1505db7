// The two ways to run a scene. They differ in distance only: the results are the same to the last bit.
#pragma once

#include <filesystem>
#include <string>

#include "animado/exit_code.hpp"
#include "controle/progress.hpp"

namespace animado {

struct RunRequest {
  std::string scene;                // path of its file
  std::filesystem::path directory;  // takes the results and, in logs/, the logs; absolute, there already
  std::string name;                 // of the run: of its socket directory, and of its shared arrays
  bool keep_services = false;
  bool physics_extensions = false;  // in animation.glb
  int pace_fd = -1;  // where controle reads how fast to go (controle/pace.hpp); -1: as fast as it can
  std::filesystem::path replay = {};  // events.jsonl of an earlier run whose edits are made again
  controle::OnProgress on_progress = {};
  std::function<void()> on_ended = {};  // controle has ended, and its files are as it left them
};

// Five processes: the four services, supervised, and controle. `finish` is called when controle has ended,
// before services that are kept are waited for; it returns where the logs are from then on.
using Finish = std::function<std::filesystem::path(ExitCode)>;
ExitCode run_with_services(const RunRequest& request, const Finish& finish);

// One process.
ExitCode run_in_process(const RunRequest& request);

}  // namespace animado
