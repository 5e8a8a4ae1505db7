// A service's entry in interexpserv's table. It is a lease that lasts as long as a connection is kept open;
// when interexpserv comes back after it was away, the service registers again. Runs inside the service's loop
// and never blocks it.
#pragma once

#include <filesystem>
#include <optional>

#include "rpc/common.hpp"
#include "rpc/connection.hpp"
#include "rpc/directory_watch.hpp"
#include "rpc/server.hpp"

namespace animado::rpc {

class Registration final : public Companion {
 public:
  Registration(const std::filesystem::path& directory, Register::Request entry, Log& log);

  int fd() const override { return connection_ ? connection_->fd() : watch_.fd(); }
  Clock::time_point next_time() const override { return next_try_; }
  void step() override;
  bool is_registered() const { return answers_ == 2; }

 private:
  void connect();
  void read_answers();
  void lose(std::string_view why);

  std::filesystem::path socket_;
  Register::Request entry_;
  Log& log_;
  DirectoryWatch watch_;
  std::optional<Connection> connection_;
  int answers_ = 0;  // to hello, to register
  Clock::time_point next_try_ = Clock::now();
};

}  // namespace animado::rpc
