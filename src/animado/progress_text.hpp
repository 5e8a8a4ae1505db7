// How far a run is, in words.
#pragma once

#include <string>

#include "controle/progress.hpp"

namespace animado {

double part_of(const controle::Progress& progress);  // 0 … 1

// "[=====     ] frame 6 of 12, t = 1.5 s, 2 bodies, 1 contact, 1200 steps/s, 3 s left". elapsed_s: since the
// run began.
std::string progress_text(const controle::Progress& progress, double elapsed_s);

}  // namespace animado
