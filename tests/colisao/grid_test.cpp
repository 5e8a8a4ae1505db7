// colisao/grid.cpp: each pair whose boxes meet, once, wherever the bodies are.
#include "colisao/grid.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

using Pairs = std::set<std::pair<int, int>>;

// Cubes about random points of a block of space.
BoundingBoxes cubes(size_t count, const Vec3& space_m, double widest_m) {
  Random random(7);
  BoundingBoxes boxes(count);
  for (size_t i = 0; i < count; ++i) {
    const double half_m = random.uniform(0.1, 0.5) * widest_m;
    for (size_t axis = 0; axis < 3; ++axis) {
      const double middle_m = random.uniform(-0.5, 0.5) * space_m[static_cast<int>(axis)];
      boxes.low(axis)[i] = middle_m - half_m;
      boxes.high(axis)[i] = middle_m + half_m;
    }
  }
  return boxes;
}

void expect_the_pairs(const BoundingBoxes& boxes, double widest_m, size_t least) {
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  Pairs found, meeting;
  Grid(boxes, all, widest_m).each_pair([&](int i, int j) {
    EXPECT_TRUE(found.insert(std::minmax(i, j)).second) << i << " and " << j << " twice";
  });
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      if (boxes.meet(static_cast<size_t>(i), static_cast<size_t>(j))) meeting.emplace(i, j);
    }
  }
  EXPECT_EQ(found, meeting);
  EXPECT_GE(meeting.size(), least);
}

TEST(Grid, FindsThePairsOfABlock) {
  expect_the_pairs(cubes(1000, {8, 8, 8}, 1), 1, 1000);
}

TEST(Grid, FindsThePairsOfARowAlongEachAxis) {
  expect_the_pairs(cubes(300, {100, 0, 0}, 1), 1, 300);
  expect_the_pairs(cubes(300, {0, 100, 0}, 1), 1, 300);
  expect_the_pairs(cubes(300, {0, 0, 100}, 1), 1, 300);
}

TEST(Grid, FindsThePairsThatAreFartherOutThanItHasCells) {
  BoundingBoxes boxes = cubes(400, {6, 6, 6}, 1);
  for (size_t i = 0; i < 200; ++i) {
    for (double* side : {boxes.low(0), boxes.high(0), boxes.low(2), boxes.high(2)}) side[i] += 1e9;
  }
  expect_the_pairs(boxes, 1, 200);
}

TEST(Grid, HasNoPairWhereEverythingIsFarApart) {
  expect_the_pairs(cubes(50, {1e7, 1e7, 1e7}, 1), 1, 0);
}

}  // namespace
}  // namespace animado::colisao
