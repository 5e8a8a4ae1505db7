// Words on pictures, in DejaVu Sans, which is part of the program: a picture does not depend on what fonts a
// machine has.
#pragma once

#include <string_view>

#include "visao/picture.hpp"

namespace animado::visao {

inline constexpr Srgb8 kInk{52, 54, 60}, kFaintInk{122, 124, 130};

// The baseline starts at (x, y). size_px: of the letters, as CSS has it. What has no letter is left out.
void write_label(Picture& picture, int x, int y, std::string_view utf8, double size_px, Srgb8 ink);
int label_width_px(std::string_view utf8, double size_px);

}  // namespace animado::visao
