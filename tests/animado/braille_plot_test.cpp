// src/animado/braille_plot.cpp: where the dots are, and what is written around them.
#include "animado/braille_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace animado {
namespace {

using testing::HasSubstr;

TEST(BraillePlot, DrawsALineFromCornerToCorner) {
  const std::vector<double> x = {0, 1};
  const std::vector<Curve> curves = {{"y", {2, 5}}};
  const std::string plot = braille_plot(x, curves, {33, 6}, false);
  // Labels of one column, a blank, the axis and 30 cells remain of 33.
  EXPECT_EQ(std::count(plot.begin(), plot.end(), '\n'), 6);
  EXPECT_THAT(plot, testing::StartsWith("5 │"));
  EXPECT_THAT(plot, HasSubstr("\n2 │⣀"));
  EXPECT_THAT(plot, HasSubstr("⠉\n"));
  EXPECT_THAT(plot, testing::EndsWith(" y\n"));
}

TEST(BraillePlot, HasAColourForEachCurve) {
  const std::vector<double> x = {0, 1};
  const std::vector<Curve> curves = {{"a", {0, 0}}, {"b", {1, 1}}};
  EXPECT_THAT(braille_plot(x, curves, {}, false), testing::Not(HasSubstr("\x1b")));
  const std::string plot = braille_plot(x, curves, {}, true);
  EXPECT_THAT(plot, HasSubstr("\x1b[36ma\x1b[0m"));
  EXPECT_THAT(plot, HasSubstr("\x1b[33mb\x1b[0m"));
}

TEST(BraillePlot, LeavesGapsWhereThereIsNoNumber) {
  const std::vector<double> x = {0, 1, 2};
  const std::vector<Curve> curves = {{"y", {1, NAN, 1}}};
  const std::string plot = braille_plot(x, curves, {40, 6}, false);
  EXPECT_THAT(plot, HasSubstr("        ")) << "nothing is drawn across the gap";
  EXPECT_THAT(braille_plot({}, {}, {}, false), HasSubstr("│"));
}

}  // namespace
}  // namespace animado
