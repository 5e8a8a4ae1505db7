// Text whose case and accents do not matter.
#pragma once

#include <string>
#include <string_view>

namespace animado {

// Lower case, accents of Latin letters removed (á → a, ç → c), one character out for each code point in, so
// that columns are kept. Other code points beyond ASCII become '?'. Input is UTF-8; a byte that is not
// becomes '?' too.
std::string fold(std::string_view text);

}  // namespace animado
