// Units where they stand are checked against what a property measures; a number without one is SI.
#pragma once

#include "controle/scene/outline.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {

// Throws Error, code type, with the place of the first value that measures something else than its property.
// `scene` was read from `outline`.
void check_dimensions(const Outline& outline, const Scene& scene);

}  // namespace animado::controle
