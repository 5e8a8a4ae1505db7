// src/visao/label.cpp
#include "visao/label.hpp"

#include <gtest/gtest.h>

namespace animado::visao {
namespace {

constexpr Srgb8 kWhite{255, 255, 255};

int64_t ink(const Picture& picture) {
  int64_t sum = 0;
  for (int y = 0; y < picture.size().height_px; ++y) {
    for (int x = 0; x < picture.size().width_px; ++x) sum += 255 - picture.at(x, y).green;
  }
  return sum;
}

TEST(Label, WritesWhereItIsTold) {
  Picture picture({200, 40}, kWhite);
  write_label(picture, 20, 30, "t = 1.14 s", 16, kInk);
  EXPECT_GT(ink(picture), 5000);
  const int width_px = label_width_px("t = 1.14 s", 16);
  for (int y = 0; y < 40; ++y) {
    for (const int x : {18, 20 + width_px + 2}) EXPECT_EQ(picture.at(x, y), kWhite) << x;
  }
}

TEST(Label, IsTheWiderTheMoreItSays) {
  EXPECT_LT(label_width_px("bola", 12), label_width_px("bola e cubo", 12));
  EXPECT_LT(label_width_px("bola", 12), label_width_px("bola", 24));
  EXPECT_EQ(label_width_px("", 12), 0);
}

TEST(Label, KnowsAccentsAndStandsTextThatIsNone) {
  Picture plain({60, 40}, kWhite), accented({60, 40}, kWhite), broken({60, 40}, kWhite);
  write_label(plain, 5, 30, "a", 24, kInk);
  write_label(accented, 5, 30, "ã", 24, kInk);
  write_label(broken, 5, 30, "\xE3", 24, kInk);  // Latin-1: taken for the letter that it is
  EXPECT_GT(ink(accented), ink(plain));
  EXPECT_EQ(ink(broken), ink(accented));
}

TEST(Label, IsCutAtTheEdge) {
  Picture picture({30, 10}, kWhite);
  write_label(picture, -5, 12, "beyond every edge", 24, kInk);
  EXPECT_GT(ink(picture), 0);
}

}  // namespace
}  // namespace animado::visao
