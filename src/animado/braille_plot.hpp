// Curves drawn in text: each cell is a Braille sign of 2 × 4 dots.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace animado {

struct Curve {
  std::string name;
  std::vector<double> y;  // at each x; NaN leaves a gap
};

struct PlotSize {
  int columns = 80, lines = 20;  // of the whole drawing, labels and legend among them; at least 30 × 6
};

// What fits the terminal there; elsewhere what COLUMNS says, or the default.
PlotSize plot_size(int descriptor);

// Lines that end with a newline: the curves over x between their extremes, what the axes span, and which
// curve is which. With colours each curve has its own (ECMA-48), without them only the legend of one curve is
// needed.
std::string braille_plot(std::span<const double> x, std::span<const Curve> curves, PlotSize size,
                         bool colours);

}  // namespace animado
