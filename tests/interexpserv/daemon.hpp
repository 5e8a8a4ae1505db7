// A real interexpserv in a folder of its own, for tests that kill it.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <filesystem>
#include <string>

#include "rpc/socket_suite.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::interexpserv {

class Daemon {
 public:
  Daemon() { start(); }
  ~Daemon() { end(SIGTERM); }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // A connection of its own to it; whoever calls over it waits until the daemon answers.
  rpc::SocketSuite connect() const {
    return rpc::SocketSuite({.directory = directory_, .client = "test", .trace = "test"});
  }

  void start() {
    const std::string program = ANIMADO_BIN_DIR "/interexpserv", store = directory_ / "names.sqlite";
    const char* arguments[] = {program.c_str(), "--socket-dir", directory_.path().c_str(),
                               "--store",       store.c_str(),  nullptr};
    ASSERT_EQ(posix_spawn(&pid_, program.c_str(), nullptr, nullptr, const_cast<char**>(arguments), environ),
              0);
  }

  void end(int signal) {
    ASSERT_EQ(kill(pid_, signal), 0);
    waitpid(pid_, nullptr, 0);
  }

 private:
  TemporaryDirectory directory_;
  pid_t pid_ = 0;
};

}  // namespace animado::interexpserv
