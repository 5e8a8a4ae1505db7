// Colours by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controle/scene/scene.hpp"

namespace animado::controle {

std::optional<Color> color_named(std::string_view folded_name);  // the names of CSS
std::vector<std::string> color_names();

// Colours for objects that say none: told apart on light and on dark, in turn.
Color palette_color(size_t index);

}  // namespace animado::controle
