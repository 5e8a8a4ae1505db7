// How the frames of a sheet lie on the page.
#pragma once

#include <optional>
#include <utility>

#include "visao/picture.hpp"

namespace animado::visao {

struct SheetLayout {
  Size size, cell;
  int columns, margin_px, gap_px, header_px, caption_px;  // caption: the room under a frame
  double text_px;

  std::pair<int, int> place(size_t index) const {  // left, top
    const int column = static_cast<int>(index) % columns, row = static_cast<int>(index) / columns;
    return {margin_px + column * (cell.width_px + gap_px),
            header_px + row * (cell.height_px + caption_px + gap_px)};
  }
};

// aspect: of what is to be seen, width/height. The page is of that width; its height follows from the frames
// unless it is given, and then the frames follow from it.
SheetLayout sheet_layout(size_t frames, double aspect, int width_px, std::optional<int> height_px);

}  // namespace animado::visao
