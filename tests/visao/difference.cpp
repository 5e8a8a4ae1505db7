#include "difference.hpp"

#include <algorithm>
#include <limits>

namespace animado::visao {

namespace {

constexpr int kReach = 2;

Vec3f blurred(const Picture& picture, int x, int y) {
  Vec3f sum = Vec3f::Zero();
  float count = 0;
  for (int v = y - kReach; v <= y + kReach; ++v) {
    for (int u = x - kReach; u <= x + kReach; ++u) {
      if (!picture.holds(u, v)) continue;
      sum += lab_of(picture.at(u, v));
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

Difference difference(const Picture& a, const Picture& b) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto [width_px, height_px] = a.size();
  if (width_px != b.size().width_px || height_px != b.size().height_px) return {kInfinite, kInfinite};
  Difference found{0, 0};
  // Every other place: the blur is wider than that.
  int places = 0;
  for (int y = 0; y < height_px; y += 2) {
    for (int x = 0; x < width_px; x += 2, ++places) {
      const double distance = (blurred(a, x, y) - blurred(b, x, y)).norm();
      found.mean += distance;
      found.worst = std::max(found.worst, distance);
    }
  }
  found.mean /= places;
  return found;
}

}  // namespace animado::visao
