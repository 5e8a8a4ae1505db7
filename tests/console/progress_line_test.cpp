// src/console/progress_line.cpp
#include "console/progress_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Style = ProgressLine::Style;

void show(ProgressLine& line, int percent, ProgressLine::Time now) {
  line.show(percent / 100.0, now, [&](double) { return "frame " + std::to_string(percent) + " of 100"; });
}

// What a line writes into a file.
class Written {
 public:
  std::FILE* file() { return file_.get(); }
  std::string text() {
    std::fflush(file());
    return text_of(directory_ / "out");
  }

 private:
  TemporaryDirectory directory_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{std::fopen((directory_ / "out").c_str(), "w"),
                                                        std::fclose};
};

TEST(ProgressBar, IsAsLongAsTheWorkThatIsDone) {
  EXPECT_EQ(progress_bar(0), "[                    ]");
  EXPECT_EQ(progress_bar(0.499), "[=========           ]");
  EXPECT_EQ(progress_bar(0.5), "[==========          ]");
  EXPECT_EQ(progress_bar(1), "[====================]");
}

TEST(TimeLeft, IsWhatTheWorkTookSoFarSaysOfTheRest) {
  EXPECT_EQ(time_left(0.5, 2), ", 2 s left");
  EXPECT_EQ(time_left(0.5, 60), ", 1 min left");
  EXPECT_EQ(time_left(0.25, 600), ", 30 min left");
  EXPECT_EQ(time_left(0.5, 3600), ", 1.0 h left");
  EXPECT_EQ(time_left(0.25, 3600), ", 3.0 h left");
  EXPECT_EQ(time_left(0.5, 0), "");
  EXPECT_EQ(time_left(0, 2), "");
  EXPECT_EQ(time_left(1, 2), "");
}

TEST(ProgressLine, WritesOverOneLineOfATerminalAndTakesItOff) {
  Written written;
  ProgressLine line(Style::terminal, written.file(), {});
  show(line, 1, ProgressLine::Time{} + seconds(1));
  show(line, 2, ProgressLine::Time{} + seconds(1) + milliseconds(50));  // too soon to be read
  show(line, 3, ProgressLine::Time{} + seconds(2));
  line.clear();
  const std::string text = written.text();
  EXPECT_THAT(text, testing::StartsWith("\rframe 1 of"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\n")));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("frame 2 of")));
  EXPECT_THAT(text, testing::HasSubstr("frame 3 of"));
  EXPECT_THAT(text, testing::EndsWith("\r\x1b[K"));
}

TEST(ProgressLine, IsDrawnAgainAsSoonAsItCanBeRead) {
  Written written;
  ProgressLine line(Style::terminal, written.file(), {});
  show(line, 1, ProgressLine::Time{} + seconds(1));
  show(line, 2, ProgressLine::Time{} + seconds(1) + milliseconds(100));
  EXPECT_THAT(written.text(), testing::HasSubstr("frame 2 of"));
}

TEST(ProgressLine, IsTakenOffOnceAndMayComeAgain) {
  Written written;
  ProgressLine line(Style::terminal, written.file(), {});
  line.clear();
  EXPECT_EQ(written.text(), "");
  show(line, 1, ProgressLine::Time{} + seconds(1));
  line.clear();
  const std::string taken_off = written.text();
  line.clear();
  EXPECT_EQ(written.text(), taken_off);
  show(line, 2, ProgressLine::Time{} + seconds(1));  // nobody reads the one before any more
  EXPECT_THAT(written.text(), testing::HasSubstr("frame 2 of"));
}

TEST(ProgressLine, WritesRareLinesElsewhere) {
  Written written;
  ProgressLine line(Style::lines, written.file(), {});
  for (int frame = 1; frame <= 100; ++frame) {
    show(line, frame, ProgressLine::Time{} + frame * milliseconds(250));
  }
  const std::string text = written.text();
  EXPECT_EQ(std::ranges::count(text, '\n'), 10);
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\x1b")));
}

TEST(ProgressLine, SaysEachMinuteElsewhereThatSlowWorkGoesOn) {
  Written written;
  ProgressLine line(Style::lines, written.file(), {});
  for (int second = 1; second <= 150; ++second) show(line, 1, ProgressLine::Time{} + seconds(second));
  EXPECT_EQ(written.text(), "frame 1 of 100\nframe 1 of 100\n");
}

TEST(ProgressLine, SaysNothingOfAShortRunOutsideATerminal) {
  Written written;
  ProgressLine line(Style::lines, written.file(), {});
  for (int frame = 1; frame <= 100; ++frame) {
    show(line, frame, ProgressLine::Time{} + frame * milliseconds(9));
  }
  EXPECT_EQ(written.text(), "");
}

TEST(ProgressLine, IsSilentWhenTold) {
  Written written;
  ProgressLine line(Style::silent, written.file(), {});
  show(line, 50, ProgressLine::Time{} + seconds(50));
  line.clear();
  EXPECT_EQ(written.text(), "");
}

TEST(ProgressLine, IsLostOnAFullDiskAndTheWorkGoesOn) {
  std::FILE* const full = std::fopen("/dev/full", "w");
  {
    ProgressLine line(Style::terminal, full, {});
    EXPECT_NO_THROW(show(line, 50, ProgressLine::Time{} + seconds(50)));
  }
  std::fclose(full);
}

TEST(ProgressLine, SaysHowLongTheWorkHasTaken) {
  Written written;
  ProgressLine line(Style::lines, written.file(), ProgressLine::Time{} + seconds(5));
  line.show(0.5, ProgressLine::Time{} + seconds(7),
            [](double elapsed_s) { return std::to_string(elapsed_s); });
  EXPECT_EQ(written.text(), std::to_string(2.0) + "\n");
}

}  // namespace
}  // namespace animado
