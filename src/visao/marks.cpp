#include "visao/marks.hpp"

#include <algorithm>
#include <cmath>

namespace animado::visao {

namespace {

constexpr size_t kMostMarks = 8;
constexpr Srgb8 kRed{200, 32, 44}, kHalo{255, 255, 255};

double strength(const controle::Event& event) {
  return event.impulse_N_s.value_or(Vec3::Zero()).norm();
}

// How much of a pixel a ring covers whose middle line is `from_line_px` away.
float coverage(double from_line_px, double width_px) {
  return static_cast<float>(std::clamp(0.5 + width_px / 2 - std::abs(from_line_px), 0.0, 1.0));
}

void ring(Picture& picture, double x, double y, double radius_px, double width_px) {
  const int reach = static_cast<int>(std::ceil(radius_px + 2 * width_px)) + 1;
  const int center_x = static_cast<int>(x), center_y = static_cast<int>(y);
  for (int v = center_y - reach; v <= center_y + reach; ++v) {
    for (int u = center_x - reach; u <= center_x + reach; ++u) {
      const double from_line_px = std::hypot(u + 0.5 - x, v + 0.5 - y) - radius_px;
      picture.cover(u, v, kHalo, 0.75f * coverage(from_line_px, 2.2 * width_px));
      picture.cover(u, v, kRed, coverage(from_line_px, width_px));
    }
  }
}

}  // namespace

std::vector<Vec3> impact_points(const controle::RecordedRun& run, double after_s, double until_s) {
  std::vector<const controle::Event*> impacts;
  for (const controle::Event& event : run.events) {
    const bool counts = event.kind == controle::EventKind::impact && event.point_m.has_value();
    if (counts && event.time_s > after_s && event.time_s <= until_s) impacts.push_back(&event);
  }
  std::ranges::stable_sort(impacts, std::greater(), [](const auto* event) { return strength(*event); });
  if (impacts.size() > kMostMarks) impacts.resize(kMostMarks);
  std::vector<Vec3> points_m;
  for (const controle::Event* event : impacts) points_m.push_back(*event->point_m);
  return points_m;
}

void mark(Picture& picture, const Camera& camera, std::span<const Vec3> points_m) {
  const Size size = picture.size();
  const double unit_px = std::clamp(std::min(size.width_px, size.height_px) / 200.0, 0.4, 1.7);
  for (const Vec3& point_m : points_m) {
    const Vec3 seen = camera.seen(point_m);
    if (seen.z() <= 0 || std::abs(seen.x()) > 1.1 || std::abs(seen.y()) > 1.1) continue;
    ring(picture, (seen.x() + 1) / 2 * size.width_px, (1 - seen.y()) / 2 * size.height_px, 5 * unit_px,
         1.6 * unit_px);
  }
}

}  // namespace animado::visao
