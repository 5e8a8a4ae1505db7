// src/visao/draw.cpp: light, shadow, and the same bytes each time.
#include "visao/draw.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>

#include "base/error.hpp"
#include "recorded.hpp"
#include "visao/light.hpp"
#include "visao/moments.hpp"

namespace animado::visao {
namespace {

using controle::RecordedBody;

const RecordedBody kFloor = {.name = "floor", .motion = Motion::fixed, .shape = HalfSpace{{0, 1, 0}, 0}};
const RecordedBody kBall = {.name = "ball", .color_srgb = {0.8, 0.1, 0.1}, .shape = Sphere{1}};
constexpr Size kSize{96, 96};

Picture picture_of(const controle::RecordedRun& run, const Camera& camera, Quality quality = Quality::still) {
  return draw(staged(run), poses_at_frame(run, 0), camera, kSize, quality);
}

bool is_red(Srgb8 pixel) {
  return pixel.red > pixel.green + 40;
}

// A ball's outline is a circle: from 20 m, 1 m of radius is seen under asin(1/20).
TEST(Draw, ABallIsRoundAndAsLargeAsItShouldBe) {
  const Camera camera = camera_at({0, 0, 20}, {0, 0, 0}, 1);
  const Picture picture = picture_of(recorded({kBall}, {{Vec3::Zero()}}), camera);
  const double radius_px = std::tan(std::asin(1 / 20.0)) / camera.half_width * kSize.width_px / 2;
  for (int y = 0; y < kSize.height_px; ++y) {
    for (int x = 0; x < kSize.width_px; ++x) {
      const double from_center_px = std::hypot(x + 0.5 - 48, y + 0.5 - 48);
      if (std::abs(from_center_px - radius_px) < 1) continue;
      EXPECT_EQ(is_red(picture.at(x, y)), from_center_px < radius_px) << x << ", " << y;
    }
  }
}

TEST(Draw, EveryShapeIsSeen) {
  const Hull tetrahedron = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                            {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  for (const Shape& shape : {Shape(Box{{1, 1, 1}}), Shape(Capsule{0.5, 0.5}), Shape(Cylinder{1, 1}),
                             Shape(Cone{1, 2}), Shape(tetrahedron)}) {
    RecordedBody body = kBall;
    body.shape = shape;
    const Picture picture =
        picture_of(recorded({body}, {{Vec3::Zero()}}), camera_at({4, 6, 20}, {0, 0, 0}, 1));
    EXPECT_TRUE(is_red(picture.at(48, 48))) << shape.index();
    EXPECT_FALSE(is_red(picture.at(5, 5))) << shape.index();
  }
}

TEST(Draw, ABallDarkensTheFloorUnderIt) {
  const auto floor_at = [&](double height_m) {
    const auto run = recorded({kBall, kFloor}, {{Vec3(0, height_m, 0), Vec3::Zero()}});
    const Camera camera = camera_at({0, 4, 20}, {0, 0, 0}, 1);
    const Vec3 seen = camera.seen({0, 0, 1.1});  // just before the ball
    return picture_of(run, camera)
        .at(static_cast<int>((seen.x() + 1) * 48), static_cast<int>((1 - seen.y()) * 48))
        .green;
  };
  EXPECT_LT(floor_at(1.0) + 8, floor_at(30));
}

// Where the line from the lamp through the ball's centre meets the floor, against the same place on the other
// side, to which the sky is as open.
TEST(Draw, ABallThrowsAShadow) {
  const Camera camera = camera_at({0, 4, 20}, {0, 0, 0}, 1);
  const Vec3 lamp = Light(camera).towards_lamp(0).cast<double>();
  const Vec3 in_shadow = Vec3(0, 2.5, 0) - 2.5 / lamp.y() * lamp;
  const Picture picture = picture_of(recorded({kBall, kFloor}, {{Vec3(0, 2.5, 0), Vec3::Zero()}}), camera);
  const auto brightness_at = [&](const Vec3& point_m) {
    const Vec3 seen = camera.seen(point_m);
    return picture.at(static_cast<int>((seen.x() + 1) * 48), static_cast<int>((1 - seen.y()) * 48)).green;
  };
  EXPECT_LT(brightness_at(in_shadow) + 15, brightness_at(-in_shadow));
}

TEST(Draw, TheUnderSideIsDarkerThanTheTop) {
  const Picture picture =
      picture_of(recorded({kBall}, {{Vec3::Zero()}}), camera_at({0, 0, 20}, {0, 0, 0}, 1));
  EXPECT_GT(picture.at(44, 36).red, picture.at(44, 60).red + 30);
}

TEST(Draw, WhereNothingIsTheBackgroundIsFlat) {
  const Picture picture =
      picture_of(recorded({kBall}, {{Vec3::Zero()}}), camera_at({0, 0, 20}, {0, 0, 0}, 1));
  EXPECT_EQ(picture.at(2, 2), picture.at(93, 93));
}

class Bytes : public testing::TestWithParam<Quality> {};
TEST_P(Bytes, AreTheSameForAnyNumberOfCores) {
  const auto run = recorded({kBall, kFloor}, {{Vec3(0, 1.2, 0), Vec3::Zero()}});
  const Camera camera = camera_at({3, 4, 20}, {0, 0, 0}, 1);
  const Picture all_cores = picture_of(run, camera, GetParam());
  cpu_set_t before, one;
  sched_getaffinity(0, sizeof before, &before);
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
  const Picture one_core = picture_of(run, camera, GetParam());
  sched_setaffinity(0, sizeof before, &before);
  for (int y = 0; y < kSize.height_px; ++y) {
    for (int x = 0; x < kSize.width_px; ++x)
      ASSERT_EQ(all_cores.at(x, y), one_core.at(x, y)) << x << ", " << y;
  }
}
INSTANTIATE_TEST_SUITE_P(, Bytes, testing::Values(Quality::film, Quality::still));

TEST(Draw, FarFromTheOriginIsAsNear) {
  const Vec3 away_m(1e6, 2e6, -1e6);
  const Picture near =
      picture_of(recorded({kBall}, {{Vec3::Zero()}}), camera_at({3, 4, 20}, Vec3::Zero(), 1));
  const Picture far =
      picture_of(recorded({kBall}, {{away_m}}), camera_at(away_m + Vec3(3, 4, 20), away_m, 1));
  for (int y = 0; y < kSize.height_px; ++y) {
    for (int x = 0; x < kSize.width_px; ++x) {
      EXPECT_NEAR(near.at(x, y).red, far.at(x, y).red, 3) << x << ", " << y;
    }
  }
}

TEST(Stage, AMotionThatIsTooWideIsRefused) {
  EXPECT_THROW(staged(recorded({kBall}, {{Vec3::Zero()}, {Vec3(1e200, 0, 0)}})), Error);
}

TEST(Stage, AMountainDoesNotDominateButASunIsShown) {
  RecordedBody mountain = kBall, sun = kBall;
  mountain.motion = sun.motion = Motion::fixed;
  mountain.shape = Box{{500, 500, 500}};
  const auto run = recorded({kBall, mountain, sun},
                            {{Vec3(0, 0, 0), Vec3(0, -501, 0), Vec3(2, 0, 0)}, {Vec3(4, 0, 0), {}, {}}});
  EXPECT_LT(staged(run).radius_m, 5);
  EXPECT_EQ(staged(run).motion.size(), 3u) << "the ball twice, the sun";
}

}  // namespace
}  // namespace animado::visao
