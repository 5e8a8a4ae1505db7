// src/rpc/manual_page.cpp: the page is the list.
#include "rpc/manual_page.hpp"

#include <gmock/gmock.h>

#include "fixture.hpp"

namespace animado::rpc::testing {
namespace {

using ::testing::HasSubstr;

TEST(ManualPage, ShowsEachFieldWithTypeDefaultAndMeaning) {
  const std::vector<const MessageCodec*> messages = codecs<std::tuple<Echo, Empty>>();
  const std::string page = manual_page("parrot", "It repeats.", messages);
  EXPECT_THAT(page, ::testing::StartsWith("## parrot\n\nIt repeats.\n"));
  EXPECT_THAT(page, HasSubstr("### echo\n\nSays what was said.\n"));
  EXPECT_THAT(page, HasSubstr("| `count` | integer | an integer |"));
  EXPECT_THAT(page, HasSubstr("| `color` | one of red, green, blue, default green | a choice |"));
  EXPECT_THAT(page, HasSubstr("| `points.x_m` | number | x |"));
  EXPECT_THAT(page, HasSubstr("| `maybe` | number, optional | an optional number |"));
  EXPECT_THAT(page, HasSubstr("### empty\n\nDoes nothing.\n"));
}

TEST(ManualPage, TheCommonPagesNameEveryErrorCodeAndMessage) {
  const std::string page = common_pages();
  for (int i = 0; i <= static_cast<int>(Code::internal); ++i) {
    EXPECT_THAT(page, HasSubstr(fmt::format("`{}`", name_of(static_cast<Code>(i)))));
  }
  for (const MessageCodec* message : codecs<CommonMessages>())
    EXPECT_THAT(page, HasSubstr(fmt::format("### {}\n", message->name)));
}

}  // namespace
}  // namespace animado::rpc::testing
