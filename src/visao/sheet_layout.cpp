#include "visao/sheet_layout.hpp"

#include <algorithm>
#include <cmath>

namespace animado::visao {

namespace {

constexpr double kPageAspect = 1.6;  // as screens and pages in landscape are, when nothing else is said

SheetLayout with_columns(int columns, int rows, double cell_aspect, int width_px,
                         std::optional<int> height_px) {
  SheetLayout layout{};
  layout.columns = columns;
  layout.text_px = std::clamp(width_px / 96.0, 7.0, 24.0);
  const auto text = [&](double times) { return static_cast<int>(std::lround(times * layout.text_px)); };
  layout.margin_px = text(1.5);
  layout.gap_px = text(0.6);
  layout.header_px = text(3);
  layout.caption_px = text(1.7);
  const int across_px = width_px - 2 * layout.margin_px - (columns - 1) * layout.gap_px;
  layout.cell.width_px = std::max(1, across_px / columns);
  const int around_px =
      layout.header_px + rows * layout.caption_px + (rows - 1) * layout.gap_px + layout.margin_px / 2;
  const double own_px = layout.cell.width_px / cell_aspect;
  const double given_px = height_px ? static_cast<double>(*height_px - around_px) / rows : own_px;
  layout.cell.height_px = std::max(1, static_cast<int>(given_px));
  layout.size = {width_px, height_px.value_or(around_px + rows * layout.cell.height_px)};
  return layout;
}

// How badly a layout suits: a page far from its shape, frames far from theirs, places left empty.
double badness(const SheetLayout& layout, int rows, size_t frames, double cell_aspect) {
  const double page = static_cast<double>(layout.size.width_px) / layout.size.height_px;
  const double cell = static_cast<double>(layout.cell.width_px) / layout.cell.height_px;
  const double empty = 1 - static_cast<double>(frames) / (layout.columns * rows);
  return std::abs(std::log(page / kPageAspect)) + 2 * std::abs(std::log(cell / cell_aspect)) + 2 * empty;
}

}  // namespace

SheetLayout sheet_layout(size_t frames, double aspect, int width_px, std::optional<int> height_px) {
  const double cell_aspect = std::clamp(aspect, 0.56, 2.4);  // a frame is a picture, not a line
  SheetLayout best{};
  double least = std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= static_cast<int>(frames); ++columns) {
    const int rows = (static_cast<int>(frames) + columns - 1) / columns;
    const SheetLayout layout = with_columns(columns, rows, cell_aspect, width_px, height_px);
    const double bad = badness(layout, rows, frames, cell_aspect);
    if (bad < least) best = layout, least = bad;
  }
  return best;
}

}  // namespace animado::visao
