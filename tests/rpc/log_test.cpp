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

// Lines until the next look at the disk, and some more.
void log_much(Log& log) {
  const std::string line(1000, 'x');
  for (int i = 0; i < 300; ++i) log.info(line);
  log.flush();
}

TEST_F(LogTest, ANearlyFullDiskIsLeftToOthers) {
  std::filesystem::space_info disk{uintmax_t{100} << 30, 0, uintmax_t{1} << 30};
  Log log("crow", file_, LogLevel::info, [&] { return disk; });
  log_much(log);
  EXPECT_TRUE(log.enabled(LogLevel::info));
  disk.available = (uintmax_t{1} << 30) - 1;
  log_much(log);
  EXPECT_FALSE(log.enabled(LogLevel::info));
  const auto size = std::filesystem::file_size(file_);
  log_much(log);
  EXPECT_EQ(std::filesystem::file_size(file_), size);
  log.warn("a warning");
  EXPECT_THAT(written(), ::testing::HasSubstr("warning crow - only 1023 MiB are left on this disk"));
  EXPECT_THAT(written(), ::testing::HasSubstr("warning crow - a warning"));
}

TEST_F(LogTest, OfASmallDiskATwentiethIsLeft) {
  std::filesystem::space_info disk{1000 << 20, 0, 50 << 20};
  Log log("crow", file_, LogLevel::info, [&] { return disk; });
  log_much(log);
  EXPECT_TRUE(log.enabled(LogLevel::info));
  disk.available -= 1;
  log_much(log);
  EXPECT_FALSE(log.enabled(LogLevel::info));
}

}  // namespace
}  // namespace animado::rpc::testing
