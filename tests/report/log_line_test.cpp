// src/report/log_line.cpp: the lines that the modules write are understood, and no others.
#include "report/log_line.hpp"

#include <gtest/gtest.h>

namespace animado::report {
namespace {

constexpr auto kCall = "2026-11-22T15:17:43.507262Z info controle run/15324#4 to colisao: respond 143.1 µs";
constexpr auto kEnd = "2026-11-22T15:17:43.507300Z info controle run/15324#14 step 3 ends at 0.05 s";
constexpr auto kServed =
    "2026-11-22T15:17:43.507454Z info egesp 15324#22 solve matrices=(15,15,1) pivoting=partial 107.5 µs ok";

TEST(LogLine, ACallThatWasSent) {
  const auto call = sent_call(kCall);
  ASSERT_TRUE(call);
  EXPECT_EQ(call->ended_at, "2026-11-22T15:17:43.507262Z");
  EXPECT_EQ(call->took_us, 143.1);
  EXPECT_EQ(call->to, "colisao");
  EXPECT_EQ(call->method, "respond");
  EXPECT_FALSE(sent_call(kEnd));
  EXPECT_FALSE(sent_call(kServed));
  EXPECT_FALSE(sent_call(""));
}

TEST(LogLine, ARunsNameMayLookLikeACall) {
  const auto call =
      sent_call("2026-11-22T15:17:43.5Z info controle my run to egesp: x#4 to fred: stage 1 µs");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->to, "fred");
}

TEST(LogLine, TheEndOfAStep) {
  const auto end = step_end(kEnd);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->step, 3);
  EXPECT_EQ(end->time_s, 0.05);
  EXPECT_FALSE(step_end(kCall));
  EXPECT_FALSE(step_end("2026-11-22T15:17:43.507300Z info controle a#1 step three ends at 0.05 s"));
}

TEST(LogLine, ACallThatWasServed) {
  const auto call = served_call(kServed);
  ASSERT_TRUE(call);
  EXPECT_EQ(call->method, "solve");
  EXPECT_EQ(call->took_us, 107.5);
  EXPECT_FALSE(served_call("2026-11-22T15:17:43.490979Z info egesp - registered with interexpserv"));
}

TEST(LogLine, TimesAreToldInMicroseconds) {
  EXPECT_NEAR(microseconds("2026-11-22T15:17:43.507454Z"), ((15 * 60 + 17) * 60 + 43.507454) * 1e6, 0.01);
}

}  // namespace
}  // namespace animado::report
