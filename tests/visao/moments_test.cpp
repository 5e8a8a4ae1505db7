// src/visao/moments.cpp
#include "visao/moments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "recorded.hpp"

namespace animado::visao {
namespace {

using testing::ElementsAre;

TEST(EvenFrames, BeginWithTheFirstAndEndWithTheLast) {
  EXPECT_THAT(even_frames(100, 4), ElementsAre(0, 33, 66, 99));
  EXPECT_THAT(even_frames(3, 12), ElementsAre(0, 1, 2)) << "fewer frames than wanted: all of them";
  EXPECT_THAT(even_frames(100, 1), ElementsAre(0));
  EXPECT_THAT(even_frames(0, 12), ElementsAre());
}

TEST(NamedFrames, AreANumberAListOrARange) {
  EXPECT_THAT(named_frames("3", 11), ElementsAre(0, 5, 10));
  EXPECT_THAT(named_frames("8,3,3", 11), ElementsAre(3, 8));
  EXPECT_THAT(named_frames("4..6", 11), ElementsAre(4, 5, 6));
  EXPECT_THAT(named_frames("7..7", 11), ElementsAre(7));
}

class Refused : public testing::TestWithParam<std::string> {};
TEST_P(Refused, IsToldWithItsRemedy) {
  try {
    named_frames(GetParam(), 11);
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::bad_params);
    EXPECT_EQ(error.where(), "--frames");
    EXPECT_THAT(error.remedy(), testing::HasSubstr("10..20"));
  }
}
INSTANTIATE_TEST_SUITE_P(Frames, Refused,
                         testing::Values("", "0", "x", "-3", "3,", "3,11", "6..4", "4..", "..4", "4..11"));

TEST(Poses, GoStraightAndTurnByTheShorterArc) {
  auto run = recorded({{.name = "a"}}, {{Vec3(0, 0, 0)}, {Vec3(1, 2, 0)}});
  const auto turned = [](double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())); };
  run.states[1].pose.orientation = turned(std::numbers::pi / 2);
  run.states[1].pose.orientation.coeffs() *= -1;  // the same rotation
  const std::vector<Pose> poses = poses_at(run, 0.05);
  EXPECT_LT((poses[0].position_m - Vec3(0.5, 1, 0)).norm(), 1e-12);
  EXPECT_LT(poses[0].orientation.angularDistance(turned(std::numbers::pi / 4)), 1e-12);
  EXPECT_EQ(poses_at(run, -1)[0].position_m, Vec3(0, 0, 0));
  EXPECT_EQ(poses_at(run, 9)[0].position_m, Vec3(1, 2, 0));
}

}  // namespace
}  // namespace animado::visao
