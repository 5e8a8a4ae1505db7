// src/visao/sheet_layout.cpp
#include "visao/sheet_layout.hpp"

#include <gtest/gtest.h>

namespace animado::visao {
namespace {

class Layout : public testing::TestWithParam<std::tuple<size_t, double, int>> {};

TEST_P(Layout, HasRoomForEveryFrameAndItsTime) {
  const auto& [frames, aspect, width_px] = GetParam();
  const SheetLayout layout = sheet_layout(frames, aspect, width_px, std::nullopt);
  EXPECT_EQ(layout.size.width_px, width_px);
  for (size_t k = 0; k < frames; ++k) {
    const auto [left, top] = layout.place(k);
    EXPECT_GE(top, layout.header_px);
    EXPECT_LE(left + layout.cell.width_px, width_px - layout.margin_px);
    EXPECT_LE(top + layout.cell.height_px + layout.caption_px, layout.size.height_px);
  }
  const auto [left, top] = layout.place(0);
  const auto [next_left, next_top] = layout.place(1);
  EXPECT_TRUE(next_left >= left + layout.cell.width_px || next_top >= top + layout.cell.height_px);
}
INSTANTIATE_TEST_SUITE_P(, Layout,
                         testing::Combine(testing::Values(2, 11, 12, 100),
                                          testing::Values(0.1, 0.6, 1.0, 9.0), testing::Values(320, 1440)));

TEST(SheetLayout, FramesAreAsWideAsWhatTheyShow) {
  const Size tall = sheet_layout(12, 0.6, 1440, std::nullopt).cell;
  const Size wide = sheet_layout(12, 2, 1440, std::nullopt).cell;
  EXPECT_NEAR(static_cast<double>(tall.width_px) / tall.height_px, 0.6, 0.01);
  EXPECT_NEAR(static_cast<double>(wide.width_px) / wide.height_px, 2, 0.02);
}

TEST(SheetLayout, ThePageHasTheHeightThatIsAskedFor) {
  const SheetLayout layout = sheet_layout(12, 0.6, 1280, 720);
  EXPECT_EQ(layout.size.height_px, 720);
  const auto [left, top] = layout.place(11);
  EXPECT_LE(top + layout.cell.height_px + layout.caption_px, 720);
}

}  // namespace
}  // namespace animado::visao
