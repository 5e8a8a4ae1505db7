// src/animado/running_suite.cpp: the folders of runs that follow each other, or run at once
#include "animado/running_suite.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "base/error.hpp"
#include "rpc/endpoint.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

namespace fs = std::filesystem;

class SocketDirectories : public testing::Test {
 protected:
  SocketDirectories() {
    unsetenv("ANIMADO_SOCKET_DIR");
    setenv("XDG_RUNTIME_DIR", runtime_.path().c_str(), 1);
  }
  ~SocketDirectories() override { unsetenv("XDG_RUNTIME_DIR"); }

  // By a process that ends without a word.
  static fs::path make_killed(const std::string& run) {
    const pid_t child = fork();
    if (child == 0) {
      const SocketDirectory directory(run);
      write_text(directory.path() / "names.sqlite", "what it knew");
      _exit(0);
    }
    EXPECT_EQ(waitpid(child, nullptr, 0), child);
    const fs::path left = rpc::socket_directory(run);
    EXPECT_TRUE(fs::exists(left / "names.sqlite"));
    return left;
  }

  const TemporaryDirectory runtime_;
  const fs::path runs_ = runtime_.path() / "animado";
};

TEST_F(SocketDirectories, GoWithTheirRun) {
  fs::path path;
  {
    const SocketDirectory directory("fall");
    path = directory.path();
    EXPECT_EQ(path, runs_ / "fall");
    EXPECT_TRUE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(SocketDirectories, OfKilledRunsGoWithTheNext) {
  const fs::path killed = make_killed("fall-17");
  {
    const SocketDirectory next("fall-18");
    EXPECT_FALSE(fs::exists(killed));
  }
  const fs::path same = make_killed("fall-17");
  {
    const SocketDirectory next("fall-17");
    EXPECT_EQ(next.path(), same);
    EXPECT_FALSE(fs::exists(same / "names.sqlite"));
  }
  EXPECT_FALSE(fs::exists(same));
}

TEST_F(SocketDirectories, OfLiveRunsAndOfServicesStartedByHandStay) {
  const SocketDirectory live("live");
  fs::create_directories(runs_ / "default");
  write_text(runs_ / "default/names.sqlite", "somebody's");
  const SocketDirectory next("next");
  EXPECT_TRUE(fs::exists(live.path()));
  EXPECT_TRUE(fs::exists(runs_ / "default/names.sqlite"));
}

TEST_F(SocketDirectories, AreOfOneRunEachFromTheMomentItStarts) {
  const SocketDirectory starting("fall");
  EXPECT_THROW(SocketDirectory("fall"), Error);
  EXPECT_TRUE(fs::exists(starting.path()));
}

// Next to it may lie what is not ours.
TEST_F(SocketDirectories, NextToOneThatWasGivenStay) {
  const fs::path other = make_killed("other");
  setenv("ANIMADO_SOCKET_DIR", (runs_ / "given").c_str(), 1);
  { const SocketDirectory given("fall"); }
  unsetenv("ANIMADO_SOCKET_DIR");
  EXPECT_TRUE(fs::exists(other));
}

}  // namespace
}  // namespace animado
