// Bodies of like size in the cells of a uniform grid as wide as the largest of them, each in the cell of its
// middle, so that two that meet are in one cell or in neighbours.
//
// The cells are numbered along z, then y, then x, and the bodies sorted by their number: what lies beside a
// row of cells is a run of the same list, and one pass along both finds the pairs. Memory is read in order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colisao/bounding_boxes.hpp"

namespace animado::colisao {

class Grid {
 public:
  Grid(const BoundingBoxes& boxes, std::span<const int> members, double cell_m);

  // Calls meet(i, j) once for each pair of members whose boxes meet, i and j in any order.
  template <class Meet>
  void each_pair(const Meet& meet) const {
    const uint64_t row = row_, plane = plane_;
    for (size_t m = 0; m < sorted_.size(); ++m) {
      for (size_t l = m + 1; l < sorted_.size() && sorted_[l].cell <= sorted_[m].cell + 1; ++l)
        test(m, l, meet);
    }
    // The rows on one side: those on the other see the pair from there.
    for (const uint64_t ahead : {row, plane - row, plane, plane + row}) {
      size_t first = 0;
      for (size_t m = 0; m < sorted_.size(); ++m) {
        const uint64_t beside = sorted_[m].cell + ahead;
        while (first < sorted_.size() && sorted_[first].cell + 1 < beside) ++first;
        for (size_t l = first; l < sorted_.size() && sorted_[l].cell <= beside + 1; ++l) test(m, l, meet);
      }
    }
  }

 private:
  struct Entry {
    uint64_t cell;
    int body;
  };

  template <class Meet>
  void test(size_t m, size_t l, const Meet& meet) const {
    const int i = sorted_[m].body, j = sorted_[l].body;
    if (boxes_.meet(static_cast<size_t>(i), static_cast<size_t>(j))) meet(i, j);
  }
  void sort();

  const BoundingBoxes& boxes_;
  uint64_t row_ = 1, plane_ = 1;  // from a cell to the next along y, along x
  std::vector<Entry> sorted_;
};

}  // namespace animado::colisao
