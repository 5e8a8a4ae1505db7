// Where the marks of an axis are, and what stands beside them: round numbers, a handful.
#pragma once

#include <string>
#include <vector>

namespace animado {

struct Ticks {
  double low, high;  // of the axis: the numbers lie within, a constant in the middle
  std::vector<double> at;
  std::vector<std::string> labels;
  int exponent = 0;  // the labels are in units of 10^exponent, a multiple of three
};

// About `count` ticks whose distance is 1, 2 or 5 times a power of ten.
Ticks ticks_of(double low, double high, int count);

}  // namespace animado
