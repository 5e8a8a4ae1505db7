#include "animado/braille_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "console/terminal.hpp"

namespace animado {
namespace {

constexpr int kDotsAcross = 2, kDotsDown = 4;
constexpr std::array kColours = {36, 33, 35, 32, 34, 31};

// Bits of the Unicode block U+2800, by row and column of the dot.
constexpr std::array<std::array<unsigned, kDotsAcross>, kDotsDown> kDots = {
    {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};

std::string sign_of(unsigned dots) {
  const unsigned code = 0x2800 + dots;
  return {static_cast<char>(0xe0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3f)),
          static_cast<char>(0x80 | (code & 0x3f))};
}

struct Range {
  double low = INFINITY, high = -INFINITY;

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // A constant is drawn in the middle.
  void widen() {
    if (!(low <= high)) low = high = 0;
    if (low == high) low -= 1, high += 1;
  }
  // Dot `count` lies at high.
  int dot(double value, int count) const {
    return static_cast<int>(std::lround((value - low) / (high - low) * (count - 1)));
  }
};

class Canvas {
 public:
  Canvas(int columns, int lines) : columns_(columns), cells_(static_cast<size_t>(columns * lines)) {}

  struct Cell {
    unsigned dots = 0;
    size_t curve = 0;  // the last one that came here
  };
  const Cell& cell(int column, int line) const {
    return cells_[static_cast<size_t>(line * columns_ + column)];
  }

  // Bresenham's line, in dots.
  void line(int x0, int y0, int x1, int y1, size_t curve) {
    const int dx = std::abs(x1 - x0), dy = -std::abs(y1 - y0);
    const int step_x = x0 < x1 ? 1 : -1, step_y = y0 < y1 ? 1 : -1;
    for (int error = dx + dy;;) {
      set(x0, y0, curve);
      if (x0 == x1 && y0 == y1) return;
      const int twice = 2 * error;
      if (twice >= dy) error += dy, x0 += step_x;
      if (twice <= dx) error += dx, y0 += step_y;
    }
  }

 private:
  void set(int x, int y, size_t curve) {
    Cell& cell = cells_[static_cast<size_t>(y / kDotsDown * columns_ + x / kDotsAcross)];
    cell.dots |= kDots[static_cast<size_t>(y % kDotsDown)][static_cast<size_t>(x % kDotsAcross)];
    cell.curve = curve;
  }

  int columns_;
  std::vector<Cell> cells_;
};

std::string coloured(const std::string& text, size_t curve, bool colours) {
  return colours ? fmt::format("\x1b[{}m{}\x1b[0m", kColours[curve % kColours.size()], text) : text;
}

void draw(Canvas& canvas, std::span<const double> x, const Curve& curve, size_t number, const Range& across,
          const Range& down, int width, int height) {
  for (size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(curve.y[i])) continue;
    const auto at = [&](size_t k) {
      return std::pair{across.dot(x[k], width), height - 1 - down.dot(curve.y[k], height)};
    };
    const auto [x1, y1] = at(i);
    const bool joined = i > 0 && std::isfinite(curve.y[i - 1]);
    const auto [x0, y0] = joined ? at(i - 1) : std::pair{x1, y1};
    canvas.line(x0, y0, x1, y1, number);
  }
}

}  // namespace

PlotSize plot_size(int descriptor) {
  PlotSize size;
  if (const auto terminal = terminal_size(descriptor)) {
    size = {terminal->columns, std::clamp(terminal->lines - 4, 6, 24)};
  } else if (const char* given = std::getenv("COLUMNS")) {
    size.columns = std::clamp(std::atoi(given), 30, 400);
  }
  return size;
}

std::string braille_plot(std::span<const double> x, std::span<const Curve> curves, PlotSize size,
                         bool colours) {
  Range across, down;
  for (const double value : x) across.include(value);
  for (const Curve& curve : curves)
    std::ranges::for_each(curve.y, [&](double value) { down.include(value); });
  across.widen();
  down.widen();
  const std::string top = fmt::format("{:.4g}", down.high), bottom = fmt::format("{:.4g}", down.low);
  const int margin = static_cast<int>(std::max(top.size(), bottom.size()));
  const int columns = std::max(size.columns, 30) - margin - 2, lines = std::max(size.lines, 6) - 2;
  Canvas canvas(columns, lines);
  for (size_t i = 0; i < curves.size(); ++i) {
    draw(canvas, x, curves[i], i, across, down, columns * kDotsAcross, lines * kDotsDown);
  }

  std::string out;
  for (int line = 0; line < lines; ++line) {
    out += fmt::format("{:>{}} │", line == 0 ? top : line + 1 == lines ? bottom : "", margin);
    for (int column = 0; column < columns; ++column) {
      const Canvas::Cell& cell = canvas.cell(column, line);
      out += cell.dots == 0 ? " " : coloured(sign_of(cell.dots), cell.curve, colours);
    }
    out.resize(out.find_last_not_of(' ') + 1);
    out += '\n';
  }
  const std::string left = fmt::format("{:.6g}", across.low), right = fmt::format("{:.6g}", across.high);
  out +=
      fmt::format("{:>{}} {:<{}}{}\n", "", margin, left, columns + 1 - static_cast<int>(right.size()), right);
  std::string legend;
  for (size_t i = 0; i < curves.size(); ++i) {
    legend += (i == 0 ? "" : "  ") + coloured(curves[i].name, i, colours);
  }
  return out + fmt::format("{:>{}} {}\n", "", margin, legend);
}

}  // namespace animado
