// Motions that leave what a body can do.
#pragma once

#include "base/error.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {

// Error diverged, about the body of this index, at the time of what was found.
Error divergence(const Scene& scene, size_t index, double time_s);

// Throws it about the first body of a state (13, N) that is out of the universe, faster than light, or turns
// faster than a proton could.
void check_state(const Scene& scene, const double* state, double time_s);

}  // namespace animado::controle
