// src/rpc/waiting.hpp: when the only core is handed over, and when who waits sleeps at once.
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

TEST(Patience, AWaitThatTakesLongIsFollowedByManyThatSleepAtOnce) {
  on_one_core([] {
    Patience patience;
    ASSERT_TRUE(patience.hand_over());
    work_for(kLong);
    patience.waited();
    for (int wait = 0; wait < 64; ++wait) {
      ASSERT_FALSE(patience.hand_over()) << wait;
      patience.waited();
    }
    EXPECT_TRUE(patience.hand_over());
  });
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
