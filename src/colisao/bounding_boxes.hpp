// Axis-parallel boxes, a row of numbers a side, so that a loop over bodies takes several at once.
#pragma once

#include <vector>

#include "base/spatial.hpp"

namespace animado::colisao {

class BoundingBoxes {
 public:
  explicit BoundingBoxes(size_t count) : count_(count), rows_(6 * count) {}

  size_t size() const { return count_; }
  double* low(size_t axis) { return rows_.data() + axis * count_; }
  double* high(size_t axis) { return rows_.data() + (3 + axis) * count_; }
  const double* low(size_t axis) const { return rows_.data() + axis * count_; }
  const double* high(size_t axis) const { return rows_.data() + (3 + axis) * count_; }

  bool meet(size_t i, size_t j) const {
    for (size_t axis = 0; axis < 3; ++axis) {
      if (low(axis)[i] > high(axis)[j] || low(axis)[j] > high(axis)[i]) return false;
    }
    return true;
  }
  double middle(size_t axis, size_t i) const { return 0.5 * (low(axis)[i] + high(axis)[i]); }
  // The largest extent of each, m; infinite for one that holds all space.
  std::vector<double> widths() const;

 private:
  size_t count_;
  std::vector<double> rows_;
};

// Of the balls of these radii about the origins of the bodies, all along the cubic between two states of
// shape (13, bodies), rows as in base/state.hpp: its four control points hold it in their hull.
BoundingBoxes swept_boxes(const std::vector<double>& radius_m, const double* from, const double* to,
                          double step_s, double margin_m);

}  // namespace animado::colisao
