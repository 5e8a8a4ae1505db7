#include "animado/plot_picture.hpp"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "animado/axis_ticks.hpp"
#include "base/error.hpp"
#include "controle/results/output_file.hpp"

namespace animado {

namespace {

constexpr double kWidth_px = 960, kPanel_px = 300;
constexpr double kLeft_px = 76, kRight_px = 24, kTop_px = 20, kBottom_px = 52;
constexpr double kHeader_px = 24, kGap_px = 20;  // a line of the legend; between panels
constexpr double kFont_px = 13;
constexpr double kCurve_px = 1.8, kWider_px = 0.8;  // a curve is wider than the next, which may hide it
constexpr double kPngScale = 2;                     // for screens of many dots
constexpr int kTicksAcross = 10, kTicksDown = 5;

struct Colour {
  double r, g, b;
};
constexpr Colour kInk{0.16, 0.16, 0.18}, kGrid{0.88, 0.88, 0.89}, kFrame{0.55, 0.55, 0.57};

// Okabe and Ito's: people tell them apart who are blind to red, green or blue. Yellow is left out, for it is
// hardly seen on white.
constexpr std::array<Colour, 7> kCurves = {{{0.00, 0.45, 0.70},
                                            {0.84, 0.37, 0.00},
                                            {0.00, 0.62, 0.45},
                                            {0.80, 0.47, 0.65},
                                            {0.90, 0.62, 0.00},
                                            {0.34, 0.71, 0.91},
                                            {0.00, 0.00, 0.00}}};

struct Box {
  double left, top, right, bottom;
};

class Picture {
 public:
  explicit Picture(cairo_surface_t* surface) : cairo_(cairo_create(surface), cairo_destroy) {
    cairo_select_font_face(pen(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen(), kFont_px);
    cairo_set_line_join(pen(), CAIRO_LINE_JOIN_ROUND);
  }

  void draw(const RunCurves& curves);

 private:
  struct Axes {
    Box box;
    Ticks across, down;

    double x(double value) const {
      return box.left + (value - across.low) / (across.high - across.low) * (box.right - box.left);
    }
    double y(double value) const {
      return box.bottom - (value - down.low) / (down.high - down.low) * (box.bottom - box.top);
    }
  };

  cairo_t* pen() const { return cairo_.get(); }
  void colour(const Colour& c) { cairo_set_source_rgb(pen(), c.r, c.g, c.b); }
  void choose_curve(size_t number, size_t of);
  double width_px(const std::string& text);
  // left_part: how much of it lies left of x, 0 … 1.
  void text(const std::string& text, double x, double y, double left_part);
  void line(double x0, double y0, double x1, double y1);
  void grid(const Axes& axes, bool with_times);
  void curve(const Axes& axes, const std::vector<double>& times_s, const Curve& curve);
  double header(const Panel& panel, const Ticks& down, double top);

  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

// After the last colour they begin again, dashed.
void Picture::choose_curve(size_t number, size_t of) {
  colour(kCurves[number % kCurves.size()]);
  cairo_set_line_width(pen(),
                       kCurve_px + kWider_px * static_cast<double>(std::min<size_t>(of - 1 - number, 3)));
  constexpr std::array kDashes = {6.0, 3.0};
  cairo_set_dash(pen(), kDashes.data(), number < kCurves.size() ? 0 : 2, 0);
}

double Picture::width_px(const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(pen(), text.c_str(), &extents);
  return extents.x_advance;
}

void Picture::text(const std::string& text, double x, double y, double left_part) {
  cairo_move_to(pen(), x - left_part * width_px(text), y);
  cairo_show_text(pen(), text.c_str());
}

void Picture::line(double x0, double y0, double x1, double y1) {
  cairo_move_to(pen(), x0, y0);
  cairo_line_to(pen(), x1, y1);
  cairo_stroke(pen());
}

void Picture::grid(const Axes& axes, bool with_times) {
  cairo_set_dash(pen(), nullptr, 0, 0);
  cairo_set_line_width(pen(), 1);
  const Box& box = axes.box;
  for (size_t i = 0; i < axes.down.at.size(); ++i) {
    const double y = axes.y(axes.down.at[i]);
    colour(kGrid);
    line(box.left, y, box.right, y);
    colour(kInk);
    text(axes.down.labels[i], box.left - 8, y + kFont_px / 3, 1);
  }
  for (size_t i = 0; i < axes.across.at.size(); ++i) {
    const double x = axes.x(axes.across.at[i]);
    colour(kGrid);
    line(x, box.top, x, box.bottom);
    colour(kInk);
    if (with_times) text(axes.across.labels[i], x, box.bottom + 18, 0.5);
  }
  colour(kFrame);
  cairo_rectangle(pen(), box.left, box.top, box.right - box.left, box.bottom - box.top);
  cairo_stroke(pen());
}

void Picture::curve(const Axes& axes, const std::vector<double>& times_s, const Curve& curve) {
  bool joined = false;
  for (size_t i = 0; i < times_s.size(); ++i) {
    const bool finite = std::isfinite(curve.y[i]);
    if (finite && joined) cairo_line_to(pen(), axes.x(times_s[i]), axes.y(curve.y[i]));
    if (finite && !joined) cairo_move_to(pen(), axes.x(times_s[i]), axes.y(curve.y[i]));
    joined = finite;
  }
  cairo_stroke(pen());
}

std::string with_exponent(const std::string& label, int exponent) {
  return exponent == 0 ? label : fmt::format("{}  × 1e{}", label, exponent);
}

// The quantity, and the curves by colour; on as many lines as they need. Returns where it ends.
double Picture::header(const Panel& panel, const Ticks& down, double top) {
  constexpr double kSample_px = 22, kSpace_px = 8, kApart_px = 20;
  double x = kLeft_px, y = top + kFont_px;
  const std::string label = with_exponent(label_of(panel), down.exponent);
  cairo_select_font_face(pen(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  colour(kInk);
  text(label, x, y, 0);
  x += width_px(label) + kApart_px;
  cairo_select_font_face(pen(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (size_t i = 0; i < panel.curves.size(); ++i) {
    const std::string& name = panel.curves[i].name;
    const double width = kSample_px + kSpace_px + width_px(name);
    if (x + width > kWidth_px - kRight_px) x = kLeft_px, y += kHeader_px;
    choose_curve(i, panel.curves.size());
    line(x, y - kFont_px / 3, x + kSample_px, y - kFont_px / 3);
    colour(kInk);
    text(name, x + kSample_px + kSpace_px, y, 0);
    x += width + kApart_px;
  }
  return y + kHeader_px - kFont_px;
}

Ticks ticks_of(const Panel& panel) {
  double low = INFINITY, high = -INFINITY;
  for (const Curve& curve : panel.curves) {
    for (const double y : curve.y) {
      if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
    }
  }
  if (!(low <= high)) low = high = 0;
  constexpr double kMargin = 0.04;  // so that a curve does not run along the frame
  const double margin = kMargin * (high - low);
  return animado::ticks_of(low - margin, high + margin, kTicksDown);
}

void Picture::draw(const RunCurves& curves) {
  cairo_set_source_rgb(pen(), 1, 1, 1);
  cairo_paint(pen());
  const Ticks across = animado::ticks_of(curves.times_s.front(), curves.times_s.back(), kTicksAcross);
  double top = kTop_px;
  for (const Panel& panel : curves.panels) {
    const bool last = &panel == &curves.panels.back();
    const Ticks down = ticks_of(panel);
    const double bottom = top + kPanel_px - kGap_px;
    const Axes axes{{kLeft_px, header(panel, down, top), kWidth_px - kRight_px, bottom}, across, down};
    grid(axes, last);
    for (size_t i = 0; i < panel.curves.size(); ++i) {
      choose_curve(i, panel.curves.size());
      curve(axes, curves.times_s, panel.curves[i]);
    }
    top += kPanel_px;
  }
  colour(kInk);
  text(with_exponent("time (s)", across.exponent), (kLeft_px + kWidth_px - kRight_px) / 2, top - kGap_px + 40,
       0.5);
}

cairo_status_t keep(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

std::string svg_text(const RunCurves& curves, double height_px) {
  std::string bytes;
  Surface surface(cairo_svg_surface_create_for_stream(keep, &bytes, kWidth_px, height_px),
                  cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  Picture(surface.get()).draw(curves);
  cairo_surface_finish(surface.get());
  return bytes;
}

std::string png_bytes(const RunCurves& curves, double height_px) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(kPngScale * kWidth_px)),
                                 static_cast<int>(std::lround(kPngScale * height_px))),
      cairo_surface_destroy);
  cairo_surface_set_device_scale(surface.get(), kPngScale, kPngScale);
  Picture(surface.get()).draw(curves);
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface.get(), keep, &bytes) != CAIRO_STATUS_SUCCESS)
    throw Error(Code::internal, "the plot could not be encoded");
  return bytes;
}

}  // namespace

void write_picture(const RunCurves& curves, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".svg" && ending != ".png")
    throw Error(Code::bad_params, "a plot is an SVG or a PNG picture", file.string(),
                "let the name end in .svg or .png; --csv writes a table");
  const double height_px =
      kTop_px + kPanel_px * static_cast<double>(curves.panels.size()) - kGap_px + kBottom_px;
  controle::write_whole(file, ending == ".svg" ? svg_text(curves, height_px) : png_bytes(curves, height_px));
}

}  // namespace animado
