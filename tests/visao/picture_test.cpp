// src/visao/picture.cpp and color.cpp
#include "visao/picture.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::visao {
namespace {

TEST(Picture, IsReadBackFromItsFileAsItWas) {
  const TemporaryDirectory directory;
  Picture picture({7, 5}, {1, 2, 3});
  picture.at(6, 4) = {255, 128, 0};
  write_png(directory / "a.png", picture);
  const Picture read = read_png(directory / "a.png");
  ASSERT_EQ(read.size().width_px, 7);
  ASSERT_EQ(read.size().height_px, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) EXPECT_EQ(read.at(x, y), picture.at(x, y));
  }
}

TEST(Picture, ThatCannotBeWrittenOrReadIsAnError) {
  EXPECT_THROW(write_png("/nowhere/a.png", Picture({2, 2}, {})), Error);
  EXPECT_THROW(read_png("/nowhere/a.png"), Error);
}

TEST(Color, GoesToLightAndBack) {
  for (const int grey : {0, 1, 10, 60, 128, 180, 210}) {  // below the shoulder
    const auto level = static_cast<uint8_t>(grey);
    EXPECT_NEAR(srgb8_of(linear_of(Vec3::Constant(grey / 255.0))).green, level, 1) << grey;
  }
  EXPECT_LE(srgb8_of(Vec3f::Constant(50)).red, 255);
}

TEST(Color, LabIsThatOfTheCie) {  // reference values of sRGB's corners
  EXPECT_LT((lab_of({255, 255, 255}) - Vec3f(100, 0, 0)).norm(), 0.1);
  EXPECT_LT((lab_of({255, 0, 0}) - Vec3f(53.24f, 80.09f, 67.20f)).norm(), 0.3);
  EXPECT_LT((lab_of({0, 0, 255}) - Vec3f(32.30f, 79.19f, -107.86f)).norm(), 0.3);
}

}  // namespace
}  // namespace animado::visao
