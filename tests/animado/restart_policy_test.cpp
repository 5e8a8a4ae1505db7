// src/animado/restart_policy.cpp
#include "animado/restart_policy.hpp"

#include <gtest/gtest.h>

namespace animado {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(RestartPolicy, StartsAgainAtOnceThenAfterPausesThatDouble) {
  RestartPolicy policy;
  const RestartPolicy::Time now{};
  EXPECT_EQ(policy.died(now), milliseconds(0));
  EXPECT_EQ(policy.died(now + seconds(1)), milliseconds(50));
  EXPECT_EQ(policy.died(now + seconds(2)), milliseconds(100));
  EXPECT_EQ(policy.died(now + seconds(3)), milliseconds(200));
}

TEST(RestartPolicy, GivesUpAtTheFifthDeathInTenSeconds) {
  RestartPolicy policy;
  const RestartPolicy::Time now{};
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(policy.died(now + i * seconds(2)));
  EXPECT_FALSE(policy.died(now + milliseconds(9999)));
}

TEST(RestartPolicy, ForgetsDeathsAfterTenSeconds) {
  RestartPolicy policy;
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(policy.died(RestartPolicy::Time{} + i * milliseconds(2600))) << i;
  EXPECT_EQ(policy.died(RestartPolicy::Time{} + seconds(1000)), milliseconds(0));
}

}  // namespace
}  // namespace animado
