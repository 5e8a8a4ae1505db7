// src/live/feed.cpp: files that grow become messages, each once.
#include "live/feed.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/state.hpp"
#include "controle/results/results.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::live {
namespace {

using Json = nlohmann::json;

class FeedTest : public testing::Test {
 protected:
  FeedTest() { std::filesystem::create_directory(directory_.path() / "logs"); }

  void append(const std::string& file, const std::string& text) {
    std::ofstream(directory_.path() / file, std::ios::app) << text;
  }
  Feed::Messages take() { return feed_.take(); }
  static std::vector<double> state(double x_m) {
    std::vector<double> numbers(2 * kStateRows);
    for (size_t i = 0; i < 2; ++i) {
      BodyState body;
      body.pose.position_m = {x_m, static_cast<double>(i), 0};
      store_body(numbers.data(), 2, i, body);
    }
    return numbers;
  }

  TemporaryDirectory directory_;
  Feed feed_{directory_.path(), 2};
};

TEST_F(FeedTest, ARunThatHasNotBegunHasNothingToTell) {
  EXPECT_TRUE(take().empty());
}

TEST_F(FeedTest, TellsFramesAndEventsOnce) {
  controle::Results results(directory_.path(), {{.name = "a"}, {.name = "b"}}, "");
  results.frame({.time_s = 0.5, .contacts = 3}, state(7));
  results.event({.time_s = 0.6, .kind = controle::EventKind::impact, .bodies = {"a", "b"}});
  results.frame({.time_s = 1}, state(8));
  const auto messages = take();
  ASSERT_EQ(messages.size(), 3);
  EXPECT_EQ(messages[0]["type"], "event");
  EXPECT_EQ(messages[0]["kind"], "impact");
  EXPECT_EQ(messages[1]["type"], "frame");
  EXPECT_EQ(messages[1]["frame"], 0);
  EXPECT_EQ(messages[1]["time_s"], 0.5);
  EXPECT_EQ(messages[1]["position"], Json({7, 0, 0, 7, 1, 0}));
  EXPECT_EQ(messages[1]["rotation"], Json({1, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(messages[1]["facts"]["contacts"], 3);
  EXPECT_EQ(messages[2]["frame"], 1);
  EXPECT_TRUE(take().empty());
}

TEST_F(FeedTest, AFrameIsToldWhenAllOfItIsThere) {
  append("states.csv", "header\n0,0,a,1,2,3,1,0,0,0,rest\n");
  append("frames.csv", "header\n0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n");
  EXPECT_TRUE(take().empty());
  append("states.csv", "0,0,b,4,5,6,1,0,0,");
  EXPECT_TRUE(take().empty());
  append("states.csv", "0,rest\n");
  const auto messages = take();
  ASSERT_EQ(messages.size(), 1);
  EXPECT_EQ(messages[0]["position"], Json({1, 2, 3, 4, 5, 6}));
}

TEST_F(FeedTest, TellsWhatModulesLogged) {
  append("logs/egesp.log", "one\ntwo\nhal");
  auto messages = take();
  ASSERT_EQ(messages.size(), 1);
  EXPECT_EQ(messages[0], Json({{"type", "log"}, {"module", "egesp"}, {"lines", {"one", "two"}}}));
  append("logs/egesp.log", "f\n");
  messages = take();
  ASSERT_EQ(messages.size(), 1);
  EXPECT_EQ(messages[0]["lines"], Json({"half"}));
}

TEST_F(FeedTest, OfALongLogTheEndIsTold) {
  append("logs/fred.log", std::string(100'000, 'x') + "\nlast\n");
  const auto messages = take();
  ASSERT_EQ(messages.size(), 1);
  EXPECT_EQ(messages[0]["lines"], Json({"last"}));
}

TEST_F(FeedTest, OfManyLinesTheLastThatFitAreTold) {
  std::string lines;
  for (int i = 0; i < 10'000; ++i) lines += "line " + std::to_string(i) + '\n';
  append("logs/fred.log", lines);
  const auto messages = take();
  ASSERT_EQ(messages.size(), 1);
  const Json& told = messages[0]["lines"];
  EXPECT_EQ(told.back(), "line 9999");
  EXPECT_GT(told.size(), 3000);  // of ten bytes each, 32 KiB
  EXPECT_LT(told.size(), 3300);
}

}  // namespace
}  // namespace animado::live
