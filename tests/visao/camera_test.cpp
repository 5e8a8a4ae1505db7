// src/visao/camera.cpp: everything is in the picture, and nothing much around it.
#include "visao/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace animado::visao {
namespace {

const std::vector<Ball> kBalls = {{{0, 0, 0}, 0.5}, {{3, 1, -2}, 1}, {{-1, 4, 5}, 0.25}, {{1000, 3, 2}, 0}};

// The ball's furthest reach across and upwards: points of its surface, projected.
Eigen::Vector2d reach(const Camera& camera, const Ball& ball) {
  Eigen::Vector2d farthest(0, 0);
  for (int k = 0; k < 2000; ++k) {
    const double z = 1 - (2 * k + 1) / 2000.0, angle = 2.399963 * k, r = std::sqrt(1 - z * z);
    const Vec3 seen =
        camera.seen(ball.center_m + ball.radius_m * Vec3(r * std::cos(angle), r * std::sin(angle), z));
    EXPECT_GT(seen.z(), 0);
    farthest = farthest.cwiseMax(seen.head<2>().cwiseAbs());
  }
  return farthest;
}

class Fit : public testing::TestWithParam<std::tuple<Vec3, double, size_t>> {};

TEST_P(Fit, ShowsAllBallsAsLargeAsItCan) {
  const auto& [towards_eye, aspect, count] = GetParam();
  const std::span<const Ball> balls(kBalls.data(), count);
  const Camera camera = fitted_camera(balls, towards_eye, aspect);
  Eigen::Vector2d farthest(0, 0);
  for (const Ball& ball : balls) farthest = farthest.cwiseMax(reach(camera, ball));
  EXPECT_LT(farthest.maxCoeff(), 1);
  EXPECT_GT(farthest.maxCoeff(), 0.95);
  EXPECT_NEAR(camera.half_width / camera.half_height, aspect, 1e-12);
}
INSTANTIATE_TEST_SUITE_P(, Fit,
                         testing::Combine(testing::Values(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0.4, 0.5)),
                                          testing::Values(0.5, 1.0, 2.4), testing::Values(1, 3, 4)));

TEST(FittedCamera, LeavesAsMuchAirAboveAsBelow) {
  const std::vector<Ball> row = {{{-5, 7, 0}, 0.2}, {{5, 7, 0}, 0.2}};
  const Camera camera = fitted_camera(row, {0.3, 0.5, 1}, 1);
  const Vec3 left = camera.seen(row[0].center_m), right = camera.seen(row[1].center_m);
  EXPECT_NEAR(left.y() + right.y(), 0, 1e-2);
}

TEST(Camera, SeesRightAndUpAsTheyAre) {
  const Camera camera = camera_at({0, 0, 10}, {0, 0, 0}, 1);
  EXPECT_GT(camera.seen({1, 0, 0}).x(), 0);
  EXPECT_GT(camera.seen({0, 1, 0}).y(), 0);
  EXPECT_LT(camera.seen({0, 0, 11}).z(), 0);
  const Camera above = camera_at({0, 10, 0}, {0, 0, 0}, 1);
  EXPECT_GT(above.seen({1, 0, 0}).x(), 0);
  EXPECT_GT(above.seen({0, 0, -1}).y(), 0) << "as on a map";
}

TEST(Camera, ItsRaysGoThroughWhatItSees) {
  const Camera camera = camera_at({3, 4, 10}, {0, 1, 0}, 1.5);
  const Vec3 seen = camera.seen({1, 2, 3});
  const Vec3 ray = camera.direction(seen.x(), seen.y()).normalized();
  EXPECT_LT((ray - (Vec3(1, 2, 3) - camera.eye_m).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace animado::visao
