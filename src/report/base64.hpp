// Bytes as text that may stand in a page (RFC 4648).
#pragma once

#include <string>
#include <string_view>

namespace animado::report {

std::string base64(std::string_view bytes);

}  // namespace animado::report
