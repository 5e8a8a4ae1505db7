// A gzip stream (RFC 1952), as browsers unpack it. The same bytes give the same stream.
#pragma once

#include <string>
#include <string_view>

namespace animado::report {

std::string gzip(std::string_view bytes);

}  // namespace animado::report
