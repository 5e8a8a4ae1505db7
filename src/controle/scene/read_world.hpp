// The blocks `world` and `time`.
#pragma once

#include <span>

#include "controle/scene/constants.hpp"

namespace animado::controle {

// The methods that a scene may ask for: those that fred offers (a test compares).
std::span<const std::string_view> known_methods();

World read_world(const Outline& outline, const Constants& constants);
Time read_time(const Outline& outline, const Constants& constants);

}  // namespace animado::controle
