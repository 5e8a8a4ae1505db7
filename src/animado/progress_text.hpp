// How far a run is, in words.
#pragma once

#include <string>

#include "controle/progress.hpp"

namespace animado {

double part_of(const controle::Progress& progress);  // of the scene's time, 0 … 1

// "[=====     ] frame 6 of 12, t = 1.5 s, 3 s left, 2 bodies, 1 contact, 1200 steps/s of 0.001 s". elapsed_s:
// since the run began.
std::string progress_text(const controle::Progress& progress, double elapsed_s);

}  // namespace animado
