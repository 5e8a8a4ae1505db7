// A scene's bodies as the drafts of glTF's physics extensions have them (results/physics_extensions.hpp).
#pragma once

#include <string>
#include <vector>

#include "controle/results/physics_extensions.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {

std::vector<BodyPhysics> physics_of(const Scene& scene);

// The drafts' word for the scene's rule.
std::string combination_of(RestitutionRule rule);

}  // namespace animado::controle
