// src/animado/progress_text.cpp and the line of controle/progress.hpp
#include "animado/progress_text.hpp"

#include <gtest/gtest.h>

namespace animado {
namespace {

using controle::Progress;

Progress at_frame(int64_t frame) {
  return {frame, 100, 0.1 * static_cast<double>(frame), 10, 2, 10 * frame, 0, 3, 0.01};
}

TEST(ProgressText, SaysHowFarAndHowLong) {
  EXPECT_EQ(progress_text(at_frame(50), 2),
            "[==========          ] frame 50 of 100, t = 5 s, 2 s left, 2 bodies, 3 contacts, "
            "250 steps/s of 0.01 s");
  EXPECT_EQ(progress_text({1, 4, 10.75, 13, 1, 7200000, 0, 1, 3e-10, 10}, 3600),
            "[=====               ] frame 1 of 4, t = 10.75 s, 3.0 h left, 1 body, 1 contact, "
            "2000 steps/s of 3e-10 s");
  EXPECT_EQ(progress_text({1, 4, 0, 3, 1, 0, 0, 0}, 1),
            "[                    ] frame 1 of 4, t = 0 s, 1 body, 0 contacts");
  EXPECT_EQ(progress_text(at_frame(100), 4),
            "[====================] frame 100 of 100, t = 10 s, 2 bodies, 3 contacts, 250 steps/s of 0.01 s");
}

TEST(LineOfProgress, ComesBackAsItWas) {
  const auto read =
      controle::parse_progress_line(controle::progress_line({3, 12, 0.1, 3.3, 2, 90, 1, 4, 1e-3, 0.5}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frame, 3);
  EXPECT_EQ(read->frames, 12);
  EXPECT_EQ(read->time_s, 0.1);
  EXPECT_EQ(read->end_s, 3.3);
  EXPECT_EQ(read->bodies, 2);
  EXPECT_EQ(read->steps, 90);
  EXPECT_EQ(read->impacts, 1);
  EXPECT_EQ(read->contacts, 4);
  EXPECT_EQ(read->step_s, 1e-3);
  EXPECT_EQ(read->start_s, 0.5);
  EXPECT_FALSE(controle::parse_progress_line("3 12 0.1"));
}

}  // namespace
}  // namespace animado
