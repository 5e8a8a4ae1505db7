// src/animado/log_tail.cpp
#include "animado/log_tail.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

TEST(LogTail, GivesTheLastLinesIndented) {
  const TemporaryDirectory directory;
  const auto log = write_text(directory / "log", "one\ntwo\nthree\nfour");
  EXPECT_EQ(last_lines(log, 2), "  three\n  four\n");
  EXPECT_EQ(last_lines(log, 10), "  one\n  two\n  three\n  four\n");
}

TEST(LogTail, ReadsTheEndOfALongLog) {
  const TemporaryDirectory directory;
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "line " + std::to_string(i) + "\n";
  EXPECT_EQ(last_lines(write_text(directory / "log", text), 2), "  line 99998\n  line 99999\n");
}

TEST(LogTail, IsEmptyWithoutALog) {
  EXPECT_EQ(last_lines("/nowhere/log", 3), "");
}

}  // namespace
}  // namespace animado
