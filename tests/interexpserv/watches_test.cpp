// src/interexpserv/watches.cpp: who is told what, and what who does not listen learns later.
#include "interexpserv/watches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

using testing::ElementsAre;

// Takes what is sent, as far as the watcher has room.
struct Post {
  Watches watches;
  std::set<uint64_t> full;
  std::vector<std::string> sent;

  void change(const std::string& name, int64_t version) {
    watches.tell(name, version, [&](uint64_t connection) {
      if (full.contains(connection)) return false;
      sent.push_back(std::to_string(connection) + ":" + name);
      return true;
    });
  }
};

TEST(Watches, TellWhomItConcernsOnce) {
  Post post;
  post.watches.add(1, "ball");
  post.watches.add(1, "ball.mass");
  post.watches.add(2, "");
  post.watches.add(3, "spring");
  post.change("ball.mass", 1);
  post.change("ballast", 2);
  EXPECT_THAT(post.sent, ElementsAre("1:ball.mass", "2:ball.mass", "2:ballast"));
  EXPECT_EQ(post.watches.sequence(), 2);
  post.watches.end(2);
  post.watches.remove(1, "ball");
  post.watches.remove(1, "ball.mass");
  post.change("ball.mass", 3);
  EXPECT_EQ(post.sent.size(), 3u);
}

TEST(Watches, WhoIsFullLearnsWhatWasLostAndHoldsUpNobody) {
  Post post;
  post.watches.add(1, "");
  post.watches.add(2, "");
  post.change("a", 7);
  post.full = {1};
  post.change("b", 8);
  post.full.clear();
  post.change("c", 8);  // there is room again, but a gap stays in order
  post.change("d", 9);
  EXPECT_THAT(post.sent, ElementsAre("1:a", "2:a", "2:b", "2:c", "2:d"));
  EXPECT_FALSE(post.watches.caught_up(2));
  const auto gap = post.watches.caught_up(1);
  ASSERT_TRUE(gap);
  EXPECT_EQ(gap->first_lost, 2);
  EXPECT_EQ(gap->since, 7);
  EXPECT_FALSE(post.watches.caught_up(1));
  post.change("e", 10);
  EXPECT_THAT(post.sent.back(), "2:e");
  EXPECT_EQ(post.sent.size(), 7u);
}

}  // namespace
}  // namespace animado::interexpserv
