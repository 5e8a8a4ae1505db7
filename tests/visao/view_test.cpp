// src/visao/view.cpp
#include "visao/view.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "recorded.hpp"

namespace animado::visao {
namespace {

Stage one_ball() {
  return staged(recorded({{.name = "ball", .shape = Sphere{0.5}}}, {{Vec3(1, 2, 3)}, {Vec3(2, 2, 3)}}));
}

TEST(View, StraightOnesLookAlongAnAxis) {
  for (const auto& [name, towards_eye] : {std::pair("front", Vec3(0, 0, 1)), std::pair("side", Vec3(1, 0, 0)),
                                          std::pair("top", Vec3(0, 1, 0))}) {
    View view;
    set_camera(view, name);
    const Camera camera = camera_of(view, one_ball(), 1);
    EXPECT_EQ(camera.axes.col(2), towards_eye) << name;
    EXPECT_LT(camera.seen({1.5, 2, 3}).head<2>().norm(), 0.05) << name;
  }
}

TEST(View, ThreeQuartersComeFromACornerThatNoWallHides) {
  auto run = recorded({{.name = "ball", .shape = Sphere{0.5}},
                       {.name = "wall", .motion = Motion::fixed, .shape = HalfSpace{{-1, 0, 0}, -4}}},
                      {{Vec3(1, 2, 3), Vec3::Zero()}});
  const Vec3 towards_eye = direction_of({}, staged(run));
  EXPECT_LT(towards_eye.x(), 0);
  EXPECT_GT(towards_eye.y(), 0);
  EXPECT_GT(direction_of({}, one_ball()).x(), 0);
}

TEST(View, ACameraStandsWhereItIsTold) {
  View view;
  set_camera(view, " ( 4 , -2.5 ,9e0 ) ");
  view.look_at_m = Vec3(0, 1, 0);
  const Camera camera = camera_of(view, one_ball(), 1.5);
  EXPECT_EQ(camera.eye_m, Vec3(4, -2.5, 9));
  EXPECT_LT(camera.seen({0, 1, 0}).head<2>().norm(), 1e-12);
}

TEST(View, WhatIsNoPointIsRefusedWithItsOption) {
  View view;
  for (const std::string text : {"", "up", "(1, 2)", "(1, 2, 3) 4", "(1, 2, x)", "1, 2, 3", "(1, 2, inf)"}) {
    try {
      set_camera(view, text);
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "--camera");
    }
  }
  view.eye_m = view.look_at_m = Vec3(1, 1, 1);
  EXPECT_THROW(camera_of(view, one_ball(), 1), Error);
}

}  // namespace
}  // namespace animado::visao
