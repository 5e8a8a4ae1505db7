// src/live/history.hpp
#include "live/history.hpp"

#include <gtest/gtest.h>

namespace animado::live {
namespace {

using Messages = std::deque<std::string>;

TEST(History, KeepsTheNewestThatFit) {
  History history(6);
  for (const char* message : {"aa", "bb", "cc"}) history.add(message);
  EXPECT_EQ(history.messages(), (Messages{"aa", "bb", "cc"}));
  history.add("ddd");
  EXPECT_EQ(history.messages(), (Messages{"cc", "ddd"}));
}

TEST(History, WhatFitsNotAtAllIsNotKept) {
  History history(3);
  history.add("aa");
  history.add("bbbb");
  EXPECT_TRUE(history.messages().empty());
  history.add("cc");
  EXPECT_EQ(history.messages(), Messages{"cc"});
}

}  // namespace
}  // namespace animado::live
