// A film strip on one page: frames in rows, each with its time, rings where bodies have met since the frame
// before.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "visao/picture.hpp"
#include "visao/view.hpp"

namespace animado::visao {

struct SheetRequest {
  std::vector<size_t> frames;  // of the run, rising
  View view = {};
  int width_px = 1280;
  std::optional<int> height_px = {};  // as high as the frames are by themselves when it is not said
  std::string title = {};
};

Picture sheet(const controle::RecordedRun& run, const SheetRequest& request);

}  // namespace animado::visao
