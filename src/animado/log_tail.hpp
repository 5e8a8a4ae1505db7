// The end of a log file, for messages about what went wrong.
#pragma once

#include <filesystem>
#include <string>

namespace animado {

// The last `lines` lines, each with two spaces before it; empty when there is no such file. Reads only the
// file's end.
std::string last_lines(const std::filesystem::path& file, size_t lines);

}  // namespace animado
