#include "colisao/grid.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace animado::colisao {
namespace {

// Cells along an axis, so that a number of 64 bits holds all. What lies beyond shares the last one, which
// costs time and loses no pair: neighbours stay neighbours.
constexpr double kMostCells = 1 << 20;

// Cells are wider than asked for by this part, so that rounding puts no two neighbours two cells apart.
constexpr double kSpare = 1e-6;

constexpr int kDigit = 8;  // bits of a number that one pass of the sort looks at

}  // namespace

Grid::Grid(const BoundingBoxes& boxes, std::span<const int> members, double cell_m)
    : boxes_(boxes), sorted_(members.size()) {
  const auto middle = [&](size_t axis, size_t m) {
    return boxes.middle(axis, static_cast<size_t>(members[m]));
  };
  const double per_cell = 1 / (cell_m * (1 + kSpare));
  for (size_t m = 0; m < members.size(); ++m) sorted_[m] = {0, members[m]};
  for (size_t axis = 0; axis < 3; ++axis) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (size_t m = 0; m < members.size(); ++m) {
      least = std::min(least, middle(axis, m));
      most = std::max(most, middle(axis, m));
    }
    const auto cell_of = [&](double x) {
      return static_cast<uint64_t>(std::min((x - least) * per_cell, kMostCells));
    };
    const uint64_t stride = cell_of(most) + 3;  // an empty cell at both ends: no row runs into the next
    for (size_t m = 0; m < members.size(); ++m)
      sorted_[m].cell = sorted_[m].cell * stride + cell_of(middle(axis, m)) + 1;
    if (axis > 0) plane_ *= stride;
    if (axis > 1) row_ = stride;
  }
  sort();
}

// By cell: a radix sort, which leaves bodies of one cell in their order.
void Grid::sort() {
  uint64_t most = 0;
  for (const Entry& entry : sorted_) most = std::max(most, entry.cell);
  std::vector<Entry> next(sorted_.size());
  for (int shift = 0; shift < 64 && most >> shift > 0; shift += kDigit) {
    std::array<size_t, (1 << kDigit) + 1> first{};
    const auto digit = [&](const Entry& entry) { return (entry.cell >> shift) % (1 << kDigit); };
    for (const Entry& entry : sorted_) ++first[digit(entry) + 1];
    for (size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const Entry& entry : sorted_) next[first[digit(entry)]++] = entry;
    sorted_.swap(next);
  }
}

}  // namespace animado::colisao
