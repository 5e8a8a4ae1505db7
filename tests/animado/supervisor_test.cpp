// src/animado/supervisor.cpp: services are shell scripts here; tests/suite has the real ones.
#include "animado/supervisor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

class SupervisorTest : public testing::Test {
 protected:
  SupervisorTest() {
    sigprocmask(SIG_SETMASK, nullptr, &mask_);
    supervisor_.emplace(directory_.path());
    supervisor_->on_death = [this](const Death& death) { deaths_.push_back(death); };
  }
  ~SupervisorTest() override {
    supervisor_.reset();
    sigprocmask(SIG_SETMASK, &mask_, nullptr);
  }

  void wait_for_deaths(size_t count) {
    while (deaths_.size() < count) supervisor_->wait({}, -1);
  }

  TemporaryDirectory directory_;
  sigset_t mask_{};
  std::optional<Supervisor> supervisor_;
  std::vector<Death> deaths_;
};

TEST_F(SupervisorTest, StartsAgainWhatWasKilled) {
  // The first life writes its line and kills itself; the second one writes the second line and stays.
  const std::string marks = directory_ / "marks";
  supervisor_->start("fred", {"/bin/sh", "-c",
                              "echo alive >> " + marks + "; [ $(wc -l < " + marks +
                                  ") -gt 1 ] || kill -9 $$; exec sleep 1000"});
  wait_for_deaths(1);
  EXPECT_EQ(deaths_[0].service, "fred");
  EXPECT_EQ(deaths_[0].status, 128 + SIGKILL);
  while (text_of(marks) != "alive\nalive\n") supervisor_->wait({}, 1);
}

TEST_F(SupervisorTest, GivesUpWithTheLastLinesOfTheLog) {
  supervisor_->start("egesp", {"/bin/sh", "-c", "echo the memory is full; exit 9"});
  try {
    wait_for_deaths(6);
    FAIL() << "a service that dies at its start was started for ever";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_THAT(error.message(), testing::HasSubstr("egesp died 5 times in 10 s"));
    EXPECT_THAT(error.message(), testing::HasSubstr("  the memory is full\n"));
    EXPECT_THAT(error.where(), testing::EndsWith("egesp.log"));
  }
  EXPECT_EQ(deaths_.size(), 5u);
  EXPECT_EQ(deaths_[4].status, 9);
}

TEST_F(SupervisorTest, WakesForADescriptor) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const rpc::UniqueFd reading(ends[0]), writing(ends[1]);
  ASSERT_EQ(write(writing.get(), "x", 1), 1);
  supervisor_->wait(std::array{reading.get()}, -1);  // or this waits for ever
}

TEST_F(SupervisorTest, CountsInterruptions) {
  raise(SIGINT);
  raise(SIGTERM);
  supervisor_->wait({}, -1);
  EXPECT_EQ(supervisor_->interruptions(), 2);
}

TEST_F(SupervisorTest, EndsTheServices) {
  supervisor_->start(
      "colisao",
      {"/bin/sh", "-c", "trap 'echo told to end; exit 0' TERM; echo ready; while :; do sleep 0.01; done"});
  while (text_of(directory_ / "colisao.log") != "ready\n") supervisor_->wait({}, 1);
  supervisor_->stop();
  EXPECT_EQ(text_of(directory_ / "colisao.log"), "ready\ntold to end\n");
}

TEST_F(SupervisorTest, FollowsLogsThatWereMoved) {
  const std::string go = directory_ / "go";
  supervisor_->start("fred",
                     {"/bin/sh", "-c", "echo to $0; while [ ! -e " + go + " ]; do sleep 0.01; done; exit 1",
                      directory_ / "fred.log"});
  const auto moved = directory_ / "moved";
  std::filesystem::create_directory(moved);
  supervisor_->move_logs(moved);
  write_text(go, "");
  wait_for_deaths(2);
  EXPECT_THAT(text_of(moved / "fred.log"), testing::HasSubstr("to " + (moved / "fred.log").string()));
}

}  // namespace
}  // namespace animado
