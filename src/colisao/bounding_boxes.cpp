#include "colisao/bounding_boxes.hpp"

#include <algorithm>

#include "base/state.hpp"

namespace animado::colisao {

std::vector<double> BoundingBoxes::widths() const {
  std::vector<double> widths(count_, 0.0);
  for (size_t axis = 0; axis < 3; ++axis) {
    const double *l = low(axis), *h = high(axis);
    for (size_t i = 0; i < count_; ++i) widths[i] = std::max(widths[i], h[i] - l[i]);
  }
  return widths;
}

BoundingBoxes swept_boxes(const std::vector<double>& radius_m, const double* from, const double* to,
                          double step_s, double margin_m) {
  const size_t n = radius_m.size();
  const double third_s = step_s / 3;
  BoundingBoxes boxes(n);
  for (size_t axis = 0; axis < 3; ++axis) {
    const double *start = from + (kPx + axis) * n, *departure = from + (kVx + axis) * n;
    const double *end = to + (kPx + axis) * n, *arrival = to + (kVx + axis) * n;
    double *low = boxes.low(axis), *high = boxes.high(axis);
#pragma GCC ivdep
    for (size_t i = 0; i < n; ++i) {
      const double a = start[i], b = a + third_s * departure[i];
      const double d = end[i], c = d - third_s * arrival[i];
      const double reach = radius_m[i] + 0.5 * margin_m;
      low[i] = std::min(std::min(a, b), std::min(c, d)) - reach;
      high[i] = std::max(std::max(a, b), std::max(c, d)) + reach;
    }
  }
  return boxes;
}

}  // namespace animado::colisao
