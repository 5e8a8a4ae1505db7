// A run that nobody simulated: bodies that tumble over a floor, as many and as long as wanted.
#pragma once

#include "controle/results/recorded_run.hpp"

namespace animado::report {

// Spheres, boxes, capsules, cylinders, cones and hulls in turn, over a plane that is one body more. Sixty
// frames a second; each body meets its neighbour twice a second.
controle::RecordedRun sample_run(size_t bodies, size_t frames);

}  // namespace animado::report
