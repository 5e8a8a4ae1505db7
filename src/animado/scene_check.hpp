// Everything that can be wrong with a scene, found in this process before any other is started.
#pragma once

#include <string>

#include "controle/scene/scene.hpp"

namespace animado {

// Reads and checks the scene; nothing may overlap at the start. Throws Error with file:line:column and a
// remedy.
controle::Scene check_scene(const std::string& path);

}  // namespace animado
