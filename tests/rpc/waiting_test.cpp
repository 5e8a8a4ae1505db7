// src/rpc/waiting.hpp: when who waits sleeps at once.
#include "rpc/waiting.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

namespace animado::rpc {
namespace {

constexpr std::chrono::microseconds kShort{500}, kLong{2000};  // beside the 1000 from which a wait is long

void work_for(Clock::duration time) {
  const auto end = Clock::now() + time;
  while (Clock::now() < end) continue;
}

// In a thread that may use no other core.
void on_one_core(const std::function<void()>& body) {
  std::thread([&] {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(static_cast<size_t>(sched_getcpu()), &only);
    ASSERT_EQ(sched_setaffinity(0, sizeof only, &only), 0);
    body();
  }).join();
}

int rests_after_a_long_wait(Rests& rests) {
  rests.waited(kLong);
  int count = 0;
  while (rests.take()) ++count;
  return count;
}

TEST(Rests, AreMoreAfterEachLongWaitEvenWhereShortOnesCameBetween) {
  Rests rests;
  EXPECT_FALSE(rests.take());
  for (int expected : {64, 128, 256, 512, 1024, 1024}) {
    EXPECT_EQ(rests_after_a_long_wait(rests), expected);
    for (int wait = 0; wait < 20; ++wait) rests.waited(kShort);
  }
}

TEST(Rests, AreFewAgainAfterAsManyShortWaits) {
  Rests rests;
  for (int wait = 0; wait < 5; ++wait) rests_after_a_long_wait(rests);
  for (int wait = 0; wait < 1023; ++wait) rests.waited(kShort);
  EXPECT_EQ(rests_after_a_long_wait(rests), 1024);
  for (int wait = 0; wait < 1024; ++wait) rests.waited(kShort);
  EXPECT_EQ(rests_after_a_long_wait(rests), 64);
}

TEST(Patience, WhatIsThereBeforeAnybodyWaitsWasNoLongWait) {
  on_one_core([] {
    for (int attempt = 0; attempt < 100; ++attempt) {
      Patience patience;
      const auto begin = Clock::now();
      ASSERT_TRUE(patience.hand_over());
      patience.waited();
      if (Clock::now() - begin > kShort) continue;  // the core was somebody else's
      work_for(kLong);
      patience.waited();
      EXPECT_TRUE(patience.hand_over());
      return;
    }
    FAIL() << "no wait was short";
  });
}

}  // namespace
}  // namespace animado::rpc
