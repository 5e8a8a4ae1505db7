// What may change with time is compiled once before anything starts, and evaluated at the start.
#pragma once

#include "controle/scene/scene.hpp"

namespace animado::controle {

// Refuses expressions of the scene that do not compile or are not finite at the start, and puts the bodies
// with a path where it begins. Throws Error with the expression's place.
void check_expressions(Scene& scene);

}  // namespace animado::controle
