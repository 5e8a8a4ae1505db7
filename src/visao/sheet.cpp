#include "visao/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "visao/draw.hpp"
#include "visao/label.hpp"
#include "visao/marks.hpp"
#include "visao/moments.hpp"
#include "visao/sheet_layout.hpp"

namespace animado::visao {

namespace {

using controle::RecordedRun;

constexpr Srgb8 kPaper{250, 250, 248};

// As many digits as tell the frames apart.
int digits_of_times(const RecordedRun& run, const std::vector<size_t>& frames) {
  double shortest_s = std::numeric_limits<double>::infinity();
  for (size_t k = 1; k < frames.size(); ++k) {
    shortest_s = std::min(shortest_s, run.times_s[frames[k]] - run.times_s[frames[k - 1]]);
  }
  if (!std::isfinite(shortest_s)) return 2;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(shortest_s))) + 1, 0, 9);
}

// The distance of the lines on floors, at the right end of the header; returns how far to the left it
// reaches.
int write_scale(Picture& page, const SheetLayout& layout, const Stage& stage, int y) {
  const int right_px = layout.size.width_px - layout.margin_px;
  const auto lines = std::ranges::find_if(stage.planes, [](const StagedPlane& p) { return p.grid_m > 0; });
  if (lines == stage.planes.end()) return right_px;
  const std::string text = fmt::format("grid {:g} m", lines->grid_m);
  const int left_px = right_px - label_width_px(text, layout.text_px);
  write_label(page, left_px, y, text, layout.text_px, kFaintInk);
  return left_px - layout.margin_px;
}

void write_header(Picture& page, const SheetLayout& layout, const RecordedRun& run, const Stage& stage,
                  const std::string& title) {
  const double text_px = layout.text_px;
  int x = layout.margin_px;
  const int y = layout.header_px - static_cast<int>(0.75 * text_px);
  write_label(page, x, y, title, 1.25 * text_px, kInk);
  x += label_width_px(title, 1.25 * text_px) + static_cast<int>(2 * text_px);
  const int right_px = write_scale(page, layout, stage, y);
  // Who is who, as long as there is room.
  for (const controle::RecordedBody& body : run.bodies) {
    if (std::holds_alternative<HalfSpace>(body.shape)) continue;
    const int dot_px = static_cast<int>(0.75 * text_px), gap_px = static_cast<int>(0.4 * text_px);
    const int width_px = dot_px + gap_px + label_width_px(body.name, text_px);
    if (x + width_px > right_px) break;
    const Srgb8 color = srgb8_of(linear_of(body.color_srgb));
    for (int v = 0; v < dot_px; ++v) {
      for (int u = 0; u < dot_px; ++u) {
        const double from_center = std::hypot(u + 0.5 - dot_px / 2.0, v + 0.5 - dot_px / 2.0);
        page.cover(x + u, y - dot_px + v, color, static_cast<float>(dot_px / 2.0 - from_center + 0.5));
      }
    }
    write_label(page, x + dot_px + gap_px, y, body.name, text_px, kFaintInk);
    x += width_px + static_cast<int>(1.4 * text_px);
  }
}

}  // namespace

Picture sheet(const RecordedRun& run, const SheetRequest& request) {
  const Stage stage = staged(run);
  const double aspect = apparent_aspect(stage.motion, direction_of(request.view, stage));
  const SheetLayout layout = sheet_layout(request.frames.size(), aspect, request.width_px, request.height_px);
  const Size cell = layout.cell;
  const Camera camera = camera_of(request.view, stage, static_cast<double>(cell.width_px) / cell.height_px);

  Picture page(layout.size, kPaper);
  write_header(page, layout, run, stage, request.title);
  const int digits = digits_of_times(run, request.frames);
  double before_s = -std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < request.frames.size(); ++k) {
    const size_t frame = request.frames[k];
    const double time_s = run.times_s[frame];
    Picture picture = draw(stage, poses_at_frame(run, frame), camera, cell, Quality::still);
    mark(picture, camera, impact_points(run, before_s, time_s));
    const auto [left, top] = layout.place(k);
    page.paste(picture, left, top);
    write_label(page, left, top + cell.height_px + static_cast<int>(1.25 * layout.text_px),
                fmt::format("t = {:.{}f} s", time_s, digits), layout.text_px, kInk);
    before_s = time_s;
  }
  return page;
}

}  // namespace animado::visao
