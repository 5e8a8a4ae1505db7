// The scene's expressions as named definitions, and a scene in which one of them is another: what a live edit
// changes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "controle/scene/scene.hpp"

namespace animado::controle {

// Of each dynamic body NAME.mass, NAME.force and NAME.torque (its lines added up), then the scene's own
// names. Folded names.
std::vector<std::pair<std::string, std::string>> definitions_of(const Scene& scene);

// The scene with `text` in the place of what defined the name: a body's force or torque, or a name of the
// scene, which is added if it is new. Throws Error refused for what cannot be edited while a run goes (a
// mass).
Scene edited(const Scene& scene, const std::string& name, const std::string& text);

// The same, and its expressions are known to compile. Throws Error with what is wrong in `text`.
Scene checked_edit(const Scene& scene, const std::string& name, const std::string& text);

// Whether a name of definitions_of may change while a run goes.
bool may_be_edited(const std::string& name);

}  // namespace animado::controle
