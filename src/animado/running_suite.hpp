// The suites that run on this machine, by the directories of their sockets.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "rpc/socket_suite.hpp"
#include "rpc/unique_fd.hpp"

namespace animado {

// The socket directory of a run that starts here; what it holds goes when the run ends, or with the next run
// if this one is killed.
class SocketDirectory {
 public:
  explicit SocketDirectory(const std::string& run);
  ~SocketDirectory();
  SocketDirectory(const SocketDirectory&) = delete;
  SocketDirectory& operator=(const SocketDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool made_here_ = false;
  rpc::UniqueFd lock_;  // on the folder
};

// Which suite a command speaks to.
struct SuiteChoice {
  std::string run, socket_dir;
};

// The chosen suite, the one that was started last when none is chosen. Throws Error(unavailable) when there
// is none.
std::unique_ptr<rpc::SocketSuite> connect_to_suite(const SuiteChoice& choice);
std::unique_ptr<rpc::SocketSuite> find_suite(const SuiteChoice& choice);  // null when there is none

}  // namespace animado
