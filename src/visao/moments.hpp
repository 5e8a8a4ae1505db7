// Which moments of a run are shown, and where its bodies are at them.
#pragma once

#include <string>
#include <vector>

#include "controle/results/recorded_run.hpp"

namespace animado::visao {

// Recorded frames, rising, each once: from the first to the last, evenly.
std::vector<size_t> even_frames(size_t frames, size_t wanted);

// As the user names them: "12" (so many, evenly), "3,5,8" or "10..20". Throws Error(bad_params).
std::vector<size_t> named_frames(const std::string& text, size_t frames);

std::vector<Pose> poses_at_frame(const controle::RecordedRun& run, size_t frame);

// Between frames as animation.glb has it: positions along straight lines, rotations by the shorter arc.
std::vector<Pose> poses_at(const controle::RecordedRun& run, double time_s);

}  // namespace animado::visao
