// A run as the page unpacks it: a JSON header with what there is to say, then arrays of numbers.
// docs/report.md has the format.
#pragma once

#include <optional>
#include <string>

#include "controle/results/recorded_run.hpp"
#include "report/traffic.hpp"

namespace animado::report {

inline constexpr int kPayloadFormat = 1;

// States of moving bodies: what a browser holds with ease. A longer run shows every second frame, or third …
inline constexpr size_t kMostStates = 1'000'000;

// More events are no list that a person reads: beyond so many the weakest impacts are left out.
inline constexpr size_t kMostEvents = 20'000;

// Throws Error when the run has no frames, or its summary cannot be read.
std::string payload(const controle::RecordedRun& run, const std::optional<Traffic>& traffic);

}  // namespace animado::report
