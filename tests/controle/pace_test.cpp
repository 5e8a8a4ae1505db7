// src/controle/pace.cpp
#include "controle/pace.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "rpc/unique_fd.hpp"

namespace animado::controle {
namespace {

class PaceTest : public testing::Test {
 protected:
  PaceTest() {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC | O_NONBLOCK), 0);
    read_.reset(ends[0]);
    write_.reset(ends[1]);
    pace_.emplace(read_.get(), [this] {
      const bool stop = stop_;
      asked_ = true;
      asked_.notify_all();
      return stop;
    });
  }
  void say(const std::string& command) {
    EXPECT_EQ(write(write_.get(), (command + '\n').data(), command.size() + 1),
              static_cast<ssize_t>(command.size() + 1));
  }

  rpc::UniqueFd read_, write_;
  std::atomic<bool> stop_ = false, asked_ = false;
  std::optional<Pace> pace_;
};

TEST_F(PaceTest, NobodyWhoWatchesMeansNoWaiting) {
  for (int frame = 0; frame < 1000; ++frame) pace_->wait(frame);
}

TEST_F(PaceTest, AStepIsOneFrame) {
  say("pause");
  say("step");
  say("step");
  pace_->wait(0);
  pace_->wait(1);
  std::atomic<bool> waiting = true;
  std::thread run([&] {
    pace_->wait(2);
    waiting = false;
  });
  EXPECT_TRUE(waiting);
  say("resume");
  run.join();
  EXPECT_FALSE(waiting);
}

TEST_F(PaceTest, AFrameTakesItsTime) {
  say("speed 2");
  pace_->wait(10);  // from here on
  const auto begin = std::chrono::steady_clock::now();
  pace_->wait(10.1);
  pace_->wait(10.2);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(100));
}

TEST_F(PaceTest, WhoGoesAwayHoldsUpNobody) {
  say("pause");
  write_.reset();
  pace_->wait(0);
  pace_->wait(1);
}

TEST_F(PaceTest, ARunThatIsToStopDoesNotWait) {
  say("pause");
  stop_ = true;
  pace_->wait(0);
}

TEST_F(PaceTest, AStopThatComesJustBeforeAWaitIsNoticed) {
  say("pause");
  std::thread run([&] { pace_->wait(0); });
  asked_.wait(false);
  stop_ = true;
  run.join();
}

}  // namespace
}  // namespace animado::controle
