// src/animado/child.cpp
#include "animado/child.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

constexpr int kLong_ms = 10000;  // never waited for: a bound for a test that fails

class ChildTest : public testing::Test {
 protected:
  Child shell(const std::string& script, const std::vector<int>& kept_fds = {}) {
    return Child({"/bin/sh", "-c", script}, directory_ / "output", kept_fds);
  }
  TemporaryDirectory directory_;
};

TEST_F(ChildTest, GivesItsExitCode) {
  Child child = shell("exit 7");
  ASSERT_TRUE(child.wait(kLong_ms));
  EXPECT_EQ(child.reap(), 7);
  EXPECT_FALSE(child.running());
}

TEST_F(ChildTest, GivesTheSignalThatKilledIt) {
  Child child = shell("exec sleep 1000");
  EXPECT_FALSE(child.wait(0));
  child.signal(SIGKILL);
  ASSERT_TRUE(child.wait(kLong_ms));
  EXPECT_EQ(child.reap(), 128 + SIGKILL);
}

TEST_F(ChildTest, AppendsWhatItPrintsToItsFile) {
  write_text(directory_ / "output", "before\n");
  Child child = shell("echo out; echo err >&2");
  ASSERT_TRUE(child.wait(kLong_ms));
  EXPECT_EQ(text_of(directory_ / "output"), "before\nout\nerr\n");
}

TEST_F(ChildTest, RefusesAProgramThatIsNotThere) {
  try {
    Child({"/nowhere/egesp"}, directory_ / "output");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_THAT(error.message(), testing::HasSubstr("/nowhere/egesp: No such file"));
  }
}

TEST_F(ChildTest, IsOutOfReachOfTheTerminal) {
  Child child = shell("exec sleep 1000");
  EXPECT_EQ(getpgid(child.pid()), child.pid());
}

TEST_F(ChildTest, EndsWithItsOwner) {
  const int pid = [&] { return shell("exec sleep 1000").pid(); }();
  EXPECT_EQ(kill(pid, 0), -1);
}

TEST_F(ChildTest, TakesSignalsThatItsParentBlocks) {
  sigset_t taken, before;
  sigemptyset(&taken);
  sigaddset(&taken, SIGTERM);
  sigprocmask(SIG_BLOCK, &taken, &before);
  Child child = shell("exec sleep 1000");
  sigprocmask(SIG_SETMASK, &before, nullptr);
  child.signal(SIGTERM);
  ASSERT_TRUE(child.wait(kLong_ms));
  EXPECT_EQ(child.reap(), 128 + SIGTERM);
}

TEST_F(ChildTest, KeepsOnlyTheDescriptorThatItIsGiven) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const rpc::UniqueFd reading(ends[0]);
  rpc::UniqueFd writing(ends[1]);
  Child child = shell("echo hello >&" + std::to_string(writing.get()), {writing.get()});
  writing.reset();
  char text[16] = {};
  EXPECT_EQ(read(reading.get(), text, sizeof text), 6);
  EXPECT_STREQ(text, "hello\n");
}

}  // namespace
}  // namespace animado
