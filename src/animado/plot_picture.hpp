// The curves of a run as a picture: panels over one time axis, with round ticks, units and a legend. cairo
// draws SVG and PNG by the same calls.
#pragma once

#include <filesystem>

#include "animado/run_curves.hpp"

namespace animado {

// The file's ending says which: .svg or .png. Throws Error(bad_params) for another one, before anything is
// drawn, and Error(unavailable) when it cannot be written.
void write_picture(const RunCurves& curves, const std::filesystem::path& file);

}  // namespace animado
