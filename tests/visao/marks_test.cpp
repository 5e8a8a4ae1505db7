// src/visao/marks.cpp
#include "visao/marks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recorded.hpp"

namespace animado::visao {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

controle::Event impact(double time_s, const Vec3& point_m, double impulse_N_s = 1) {
  return {.time_s = time_s,
          .kind = controle::EventKind::impact,
          .point_m = point_m,
          .impulse_N_s = Vec3(0, impulse_N_s, 0)};
}

TEST(ImpactPoints, AreThoseSinceTheFrameBefore) {
  controle::RecordedRun run;
  run.events = {impact(0.1, {1, 0, 0}), impact(0.2, {2, 0, 0}), impact(0.3, {3, 0, 0})};
  run.events.push_back({.time_s = 0.2, .kind = controle::EventKind::contact_begin, .point_m = Vec3(9, 9, 9)});
  EXPECT_THAT(impact_points(run, 0.1, 0.2), ElementsAre(Vec3(2, 0, 0)));
  EXPECT_THAT(impact_points(run, -1, 1), SizeIs(3));
}

TEST(ImpactPoints, AreTheStrongestOfMany) {
  controle::RecordedRun run;
  for (int k = 0; k < 100; ++k) run.events.push_back(impact(0.1, Vec3(k, 0, 0), k));
  const std::vector<Vec3> points_m = impact_points(run, 0, 1);
  EXPECT_LT(points_m.size(), 20u);
  for (const Vec3& point_m : points_m) EXPECT_GT(point_m.x(), 80);
}

TEST(Mark, IsARingAroundThePointAsItIsSeen) {
  constexpr Srgb8 kGrey{128, 128, 128};
  Picture picture({200, 200}, kGrey);
  const Camera camera = camera_at({0, 0, 10}, {0, 0, 0}, 1);
  const Vec3 point_m(0, 5 * camera.half_height, 0);  // half-way up
  mark(picture, camera, std::array{point_m, Vec3(0, 0, 20)});
  EXPECT_EQ(picture.at(100, 50), kGrey) << "what is inside stays visible";
  const Srgb8 on_ring = picture.at(105, 50);
  EXPECT_GT(on_ring.red, 150);
  EXPECT_LT(on_ring.green, 90);
  EXPECT_EQ(picture.at(100, 150), kGrey) << "what is behind the camera is not marked";
}

}  // namespace
}  // namespace animado::visao
