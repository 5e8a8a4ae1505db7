// How a scene is refused: file:line:column, what is wrong, what to do about it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {

[[noreturn]] void refuse(std::string_view path, Place place, Code code, std::string message,
                         std::string remedy);

// "did you mean `ball`?" when a name is near, else `otherwise`.
std::string suggestion(std::string_view word, std::span<const std::string> known, std::string otherwise);

// "a, b or c"
std::string list_of(std::span<const std::string> words);

}  // namespace animado::controle
