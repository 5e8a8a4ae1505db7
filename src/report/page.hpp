// report.html: the page with one run in it. It needs no network and no server.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "controle/results/recorded_run.hpp"
#include "report/traffic.hpp"

namespace animado::report {

// The page's text.
std::string page_with(const controle::RecordedRun& run, const std::optional<Traffic>& traffic);

// The page without a run, for a server that tells it of one that goes on.
std::string live_page();

// Reads the results in `directory` and writes report.html beside them, whole or not at all. Throws Error with
// its remedy: no results there, no page in this program, no space.
void write_report(const std::filesystem::path& directory);

}  // namespace animado::report
