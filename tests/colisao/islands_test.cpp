// Tests of colisao/islands.hpp.
#include "colisao/islands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace animado::colisao {
namespace {

using ::testing::ElementsAre;
using Links = std::vector<std::pair<int, int>>;

TEST(Islands, TwoStacksOnOneFloorAreTwo) {
  const std::vector<bool> dynamic = {false, true, true,
                                     true,  true, true};  // 0 is the floor, 5 touches nothing
  const Links links = {{0, 1}, {1, 3}, {0, 2}, {2, 4}};
  const auto all = islands(dynamic, links);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_THAT(all[0].bodies, ElementsAre(1, 3));
  EXPECT_THAT(all[0].links, ElementsAre(0, 1));
  EXPECT_THAT(all[1].bodies, ElementsAre(2, 4));
  EXPECT_THAT(all[1].links, ElementsAre(2, 3));
}

TEST(Islands, OneBodyJoinsThem) {
  const std::vector<bool> dynamic = {false, true, true, true};
  const Links links = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
  const auto all = islands(dynamic, links);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_THAT(all[0].bodies, ElementsAre(1, 2, 3));
}

TEST(Islands, ImmovablePairsBelongToNone) {
  const Links links = {{0, 1}};
  EXPECT_TRUE(islands({false, false}, links).empty());
}

}  // namespace
}  // namespace animado::colisao
