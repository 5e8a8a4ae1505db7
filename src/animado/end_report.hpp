// What a run came to and where its results are, in a few lines for people: made from its summary.json.
#pragma once

#include <filesystem>
#include <string>

namespace animado {

// directory: where the results are. Throws Error(unavailable) when there is no summary to read.
std::string end_report(const std::filesystem::path& directory);

}  // namespace animado
