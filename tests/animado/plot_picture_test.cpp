// src/animado/plot_picture.cpp
#include "animado/plot_picture.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

namespace fs = std::filesystem;

RunCurves example_curves() {
  RunCurves curves;
  Curve rising{"rising", {}}, falling{"falling", {}};
  for (int k = 0; k <= 100; ++k) {
    curves.times_s.push_back(0.1 * k);
    rising.y.push_back(k);
    falling.y.push_back(k == 50 ? double{NAN} : -1.0 * k);
  }
  curves.panels = {{"energy", "J", {rising, falling}}};
  return curves;
}

// How often each colour is there.
std::map<uint32_t, int> colours_of(const fs::path& png) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_from_png(png.c_str()), cairo_surface_destroy);
  EXPECT_EQ(cairo_surface_status(surface.get()), CAIRO_STATUS_SUCCESS);
  const int width = cairo_image_surface_get_width(surface.get());
  const int height = cairo_image_surface_get_height(surface.get());
  EXPECT_EQ(width, 1920);
  EXPECT_EQ(height, 2 * (20 + 300 - 20 + 52));
  const unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  std::map<uint32_t, int> counts;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      uint32_t pixel = 0;
      std::memcpy(&pixel, bytes + y * stride + 4 * x, sizeof pixel);
      ++counts[pixel & 0xffffff];
    }
  }
  return counts;
}

// How often a colour is there, to a step in each part: cairo rounds as it likes.
int with_tone(const std::map<uint32_t, int>& colours, int r, int g, int b) {
  int count = 0;
  for (const auto& [colour, times] : colours) {
    const auto part = [c = colour](int shift) { return static_cast<int>(c >> shift & 0xff); };
    if (std::abs(part(16) - r) <= 1 && std::abs(part(8) - g) <= 1 && std::abs(part(0) - b) <= 1)
      count += times;
  }
  return count;
}

TEST(PlotPicture, PngHasEachCurveInItsColourOnWhite) {
  const TemporaryDirectory directory;
  write_picture(example_curves(), directory / "plot.png");
  const auto colours = colours_of(directory / "plot.png");
  EXPECT_GT(colours.at(0xffffff), 900'000);
  EXPECT_GT(with_tone(colours, 0x00, 0x73, 0xb2), 1000);  // blue: 0, 0.45, 0.70
  EXPECT_GT(with_tone(colours, 0xd6, 0x5e, 0x00), 1000);  // vermilion: 0.84, 0.37, 0
}

TEST(PlotPicture, SvgIsOne) {
  const TemporaryDirectory directory;
  write_picture(example_curves(), directory / "plot.svg");
  const std::string text = text_of(directory / "plot.svg");
  EXPECT_THAT(text, testing::StartsWith("<?xml"));
  EXPECT_THAT(text, testing::HasSubstr("</svg>"));
}

TEST(PlotPicture, RefusesAnotherEndingAndWritesNothing) {
  const TemporaryDirectory directory;
  EXPECT_THROW(write_picture(example_curves(), directory / "plot.gif"), Error);
  EXPECT_FALSE(fs::exists(directory / "plot.gif"));
}

}  // namespace
}  // namespace animado
