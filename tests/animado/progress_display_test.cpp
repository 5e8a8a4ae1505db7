// src/animado/progress_display.cpp and the line of controle/progress.hpp
#include "animado/progress_display.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

using controle::Progress;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Style = ProgressDisplay::Style;

Progress at_frame(int64_t frame) {
  return {frame, 100, 0.1 * static_cast<double>(frame), 10, 2, 10 * frame, 0, 3};
}

// What a display writes into a file.
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

TEST(ProgressText, SaysHowFarAndHowLong) {
  EXPECT_EQ(progress_text(at_frame(50), 2),
            "[==========          ] frame 50 of 100, t = 5 s, 2 bodies, 3 contacts, 250 steps/s, 2 s left");
  EXPECT_EQ(progress_text({1, 4, 0, 3, 1, 0, 0, 1}, 3600),
            "[=====               ] frame 1 of 4, t = 0 s, 1 body, 1 contact, 0 steps/s, 3.0 h left");
  EXPECT_EQ(progress_text(at_frame(100), 4),
            "[====================] frame 100 of 100, t = 10 s, 2 bodies, 3 contacts, 250 steps/s");
}

TEST(ProgressDisplay, WritesOverOneLineOfATerminalAndTakesItOff) {
  Written written;
  ProgressDisplay display(Style::terminal, written.file(), {});
  display.show(at_frame(1), ProgressDisplay::Time{} + seconds(1));
  display.show(at_frame(2), ProgressDisplay::Time{} + seconds(1) + milliseconds(50));  // too soon to be read
  display.show(at_frame(3), ProgressDisplay::Time{} + seconds(2));
  display.clear();
  const std::string text = written.text();
  EXPECT_THAT(text, testing::StartsWith("\r["));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\n")));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("frame 2 of")));
  EXPECT_THAT(text, testing::HasSubstr("frame 3 of"));
  EXPECT_THAT(text, testing::EndsWith("\r\x1b[K"));
}

TEST(ProgressDisplay, WritesRareLinesElsewhere) {
  Written written;
  ProgressDisplay display(Style::lines, written.file(), {});
  for (int64_t frame = 1; frame <= 100; ++frame) {
    display.show(at_frame(frame), ProgressDisplay::Time{} + frame * milliseconds(250));
  }
  const std::string text = written.text();
  EXPECT_EQ(std::ranges::count(text, '\n'), 10);
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\x1b")));
}

TEST(ProgressDisplay, SaysNothingOfAShortRunOutsideATerminal) {
  Written written;
  ProgressDisplay display(Style::lines, written.file(), {});
  for (int64_t frame = 1; frame <= 100; ++frame) {
    display.show(at_frame(frame), ProgressDisplay::Time{} + frame * milliseconds(9));
  }
  EXPECT_EQ(written.text(), "");
}

TEST(ProgressDisplay, IsSilentWhenTold) {
  Written written;
  ProgressDisplay display(Style::silent, written.file(), {});
  display.show(at_frame(50), ProgressDisplay::Time{} + seconds(50));
  display.clear();
  EXPECT_EQ(written.text(), "");
}

TEST(ProgressLine, ComesBackAsItWas) {
  const auto read = controle::parse_progress_line(controle::progress_line({3, 12, 0.1, 3.3, 2, 90, 1, 4}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frame, 3);
  EXPECT_EQ(read->frames, 12);
  EXPECT_EQ(read->time_s, 0.1);
  EXPECT_EQ(read->end_s, 3.3);
  EXPECT_EQ(read->bodies, 2);
  EXPECT_EQ(read->steps, 90);
  EXPECT_EQ(read->impacts, 1);
  EXPECT_EQ(read->contacts, 4);
  EXPECT_FALSE(controle::parse_progress_line("3 12 0.1"));
}

}  // namespace
}  // namespace animado
