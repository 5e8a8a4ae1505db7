// Files that a scene names, line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace animado::controle {

// Throws Error unavailable when it is not there or cannot be read.
std::string read_text(const std::string& path);

// The path of a file that the scene `scene` names: relative to its folder.
std::string beside(const std::string& scene, std::string_view file);

// The parts between any of the separators, without the empty ones.
std::vector<std::string_view> split(std::string_view text, std::string_view separators);

// A finite number and nothing else. Throws Error: syntax, not_finite, at `where`.
double to_number(std::string_view text, const std::string& where);

}  // namespace animado::controle
