// `animado run --live`: a page that watches the run.
#pragma once

#include <memory>

#include "animado/run_ways.hpp"
#include "live/watch.hpp"

namespace animado {

// Says the page's address; the run waits until it is opened. Throws Error when the port is taken.
std::unique_ptr<live::Watch> watch_run(const RunRequest& request, uint16_t port);

// Tells the page how the run ended. results: where its files are.
void end_watch(live::Watch& watch, const std::filesystem::path& results);

}  // namespace animado
