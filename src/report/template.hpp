// The page that web/ builds, as it lies in this program: one HTML text with its scripts and styles, and a
// comment where the run goes.
#pragma once

#include <string_view>

namespace animado::report {

// Throws Error(unavailable) in a program that was built without it (ANIMADO_WEB=OFF).
std::string_view page_template();

}  // namespace animado::report
