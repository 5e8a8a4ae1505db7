// Points of a Wavefront OBJ file.
#pragma once

#include <string>
#include <vector>

#include "base/spatial.hpp"

namespace animado::controle {

// The vertices (`v` lines, m) that faces (`f` lines) mention, in their order; all of them when there is no
// face. Other lines are not needed here. Throws Error: unavailable when the file cannot be read; syntax or
// not_finite, with file:line, when a line makes no sense.
std::vector<Vec3> read_obj(const std::string& path);

}  // namespace animado::controle
