// The page of a run, put beside its numbers.
#pragma once

#include <filesystem>

namespace animado {

// report.html into the folder of the results. One that cannot be made spoils no run: it is said on stderr,
// with what to do. results: where the run's files are now; final_results: where they will be when somebody
// reads that.
void add_report(const std::filesystem::path& results, const std::filesystem::path& final_results);

}  // namespace animado
