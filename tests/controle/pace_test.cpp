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
      ++asked_;
      asked_.notify_all();
      return stop;
    });
  }
  // A frame that does not go on until `command` comes: it asks again and again whether it is to stop.
  void expect_waits(double time_s, const std::string& command) {
    const int before = asked_;
    std::atomic<bool> waiting = true;
    std::thread run([&] {
      pace_->wait(time_s);
      waiting = false;
      asked_ += 2;
      asked_.notify_all();
    });
    for (int now; (now = asked_) < before + 2;) asked_.wait(now);
    EXPECT_TRUE(waiting) << time_s;
    say(command);
    run.join();
  }
  void say(const std::string& command) {
    EXPECT_EQ(write(write_.get(), (command + '\n').data(), command.size() + 1),
              static_cast<ssize_t>(command.size() + 1));
  }

  rpc::UniqueFd read_, write_;
  std::atomic<bool> stop_ = false;
  std::atomic<int> asked_ = 0;
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
  expect_waits(2, "resume");
}

TEST_F(PaceTest, AStepPausesWhatWasGoingOn) {
  say("step");
  pace_->wait(0);
  expect_waits(1, "step");
  expect_waits(2, "resume");
  pace_->wait(3);
}

TEST_F(PaceTest, APauseTakesBackStepsThatWereNotMade) {
  say("step");
  say("step");
  say("pause");
  expect_waits(0, "resume");
}

TEST_F(PaceTest, AFrameTakesItsTime) {
  say("speed 0.5");
  pace_->wait(10);  // from here on
  const auto begin = std::chrono::steady_clock::now();
  pace_->wait(10.025);
  pace_->wait(10.05);
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
  asked_.wait(0);
  stop_ = true;
  run.join();
}

}  // namespace
}  // namespace animado::controle
