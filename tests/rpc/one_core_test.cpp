#include "rpc/one_core.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <thread>

namespace animado::rpc {
namespace {

cpu_set_t allowed() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  sched_getaffinity(0, sizeof cores, &cores);
  return cores;
}

// Runs on this machine may hold every core just now: then nothing changes.
TEST(OneCore, KeepsToOneOfTheCoresAndGivesTheOthersBack) {
  const cpu_set_t before = allowed();
  {
    const OneCore core;
    const cpu_set_t during = allowed();
    cpu_set_t both;
    CPU_AND(&both, &before, &during);
    EXPECT_TRUE(CPU_EQUAL(&both, &during));
    EXPECT_TRUE(CPU_COUNT(&during) == 1 || CPU_EQUAL(&during, &before));
  }
  const cpu_set_t after = allowed();
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

TEST(OneCore, NoTwoRunsTakeTheSame) {
  std::array<cpu_set_t, 2> taken;
  std::latch both_hold(2);
  const auto run = [&](cpu_set_t& cores) {
    const OneCore core;
    cores = allowed();
    both_hold.arrive_and_wait();
  };
  std::thread first(run, std::ref(taken[0])), second(run, std::ref(taken[1]));
  first.join();
  second.join();
  if (CPU_COUNT(&taken[0]) == 1 && CPU_COUNT(&taken[1]) == 1) {
    EXPECT_EQ(sysconf(_SC_NPROCESSORS_ONLN) > 1, !CPU_EQUAL(&taken[0], &taken[1]));
  }
}

TEST(OneCore, TheOnlyCoreThatIsAllowedStays) {
  std::thread([] {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(static_cast<size_t>(sched_getcpu()), &only);
    ASSERT_EQ(sched_setaffinity(0, sizeof only, &only), 0);
    {
      const OneCore core;
      const cpu_set_t during = allowed();
      EXPECT_TRUE(CPU_EQUAL(&only, &during));
    }
    const cpu_set_t after = allowed();
    EXPECT_TRUE(CPU_EQUAL(&only, &after));
  }).join();
}

}  // namespace
}  // namespace animado::rpc
