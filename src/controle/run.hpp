// A run: from a scene's file to the files of its results (design, sections 5 and 8).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "controle/progress.hpp"
#include "controle/results/results.hpp"
#include "controle/scene/scene.hpp"
#include "rpc/channel.hpp"

namespace animado::controle {

struct RunOptions {
  std::string scene;                             // path of its file
  std::filesystem::path directory;               // where the results are written; it is there already
  std::string name = "run";                      // tells this run's shared arrays from another's
  bool physics_extensions = false;               // in animation.glb: drafts (results/physics_extensions.hpp)
  OnProgress progress = [](const Progress&) {};  // called at every frame, and within one that takes long
  std::function<void(double time_s)> pace = [](double) {};  // asked at every frame: returns when it may go on
  std::vector<Event> edits = {};                            // to be made again, of an earlier run's events
  std::function<bool()> stop = [] { return false; };        // asked at every step: Ctrl-C
};

std::vector<ResultBody> result_bodies(const Scene& scene);

// Runs the scene with the other modules of the suite. A motion that diverges (Error diverged) leaves the
// frames so far and their summary before the error goes on to the caller; so does a lost service. A scene
// that makes no sense is refused (Error) before anything is written.
Summary run(const RunOptions& options, rpc::Suite& suite);

}  // namespace animado::controle
