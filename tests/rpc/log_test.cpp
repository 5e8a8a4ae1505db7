// src/rpc/log.cpp: lines are collected, and none is lost or late that somebody waits for.
#include "rpc/log.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/temporary_directory.hpp"

namespace animado::rpc::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::MatchesRegex;

class LogTest : public ::testing::Test {
 protected:
  std::string written() const {
    std::ifstream in(file_);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  TemporaryDirectory directory_;
  const std::filesystem::path file_ = directory_.path() / "crow.log";
};

TEST_F(LogTest, LinesWaitForTheFlush) {
  Log log("crow", file_);
  log.info("one");
  EXPECT_TRUE(log.dirty());
  log.format();
  EXPECT_THAT(written(), IsEmpty());
  log.flush();
  EXPECT_FALSE(log.dirty());
  EXPECT_THAT(written(), MatchesRegex("[-0-9T:.]+Z info crow - one\n"));
}

TEST_F(LogTest, AWarningIsThereAtOnceBehindWhatCameBefore) {
  Log log("crow", file_);
  log.info("one");
  log.warn("two");
  EXPECT_THAT(written(), MatchesRegex(".* - one\n.* warning crow - two\n"));
}

TEST_F(LogTest, ALineTellsWhenItHappenedNotWhenItWasWritten) {
  Log log("crow", file_);
  const auto now = Log::Time::clock::now();
  log.write(LogLevel::info, "- late", now - std::chrono::hours(24));
  log.write(LogLevel::info, "- now", now);
  log.flush();
  const std::string text = written();
  const std::string second_line = text.substr(text.find('\n') + 1);
  EXPECT_NE(text.substr(0, 10), second_line.substr(0, 10));  // the date
}

TEST_F(LogTest, WhatWasCollectedIsWrittenAtTheEnd) {
  Log("crow", file_).info("one");
  EXPECT_THAT(written(), MatchesRegex(".* - one\n"));
}

TEST_F(LogTest, ManyLinesAreNotHeldBackForEver) {
  Log log("crow", file_);
  for (int i = 0; i < 100000 && written().empty(); ++i) log.info("a line");
  EXPECT_THAT(written(), ::testing::Not(IsEmpty()));
}

}  // namespace
}  // namespace animado::rpc::testing
