// The page that web/ builds, as it lies in this program: one HTML text with its scripts and styles, and a
// comment where the run goes.
#pragma once

#include <string_view>

namespace animado::report {

bool has_page_template();  // not in a program that was built with ANIMADO_WEB=OFF

// Throws Error(unavailable) where there is none.
std::string_view page_template();

}  // namespace animado::report
