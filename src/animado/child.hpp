// A process that this one started. It dies with its parent, ignores the terminal's Ctrl-C (its parent decides
// who ends when), and writes what it prints into a file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rpc/unique_fd.hpp"

namespace animado {

class Child {
 public:
  Child() = default;  // no process
  // Starts arguments[0]. Output and errors are appended to the file `output`. `kept_fds` stay open in
  // the child. Throws Error(unavailable) when the program cannot be started.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& output,
        std::span<const int> kept_fds = {});
  Child(Child&&) noexcept = default;
  Child& operator=(Child&& other) noexcept;
  ~Child();  // ends it, by force

  bool running() const { return static_cast<bool>(pidfd_); }
  pid_t pid() const { return pid_; }
  int pidfd() const { return pidfd_.get(); }  // readable when the process has ended; -1 without a process

  void signal(int number) const;
  bool wait(int timeout_ms) const;  // whether it ended in time; without a process, at once
  // Takes the exit status of a process that has ended: what it returned, or 128 + the signal that killed it.
  int reap();

 private:
  pid_t pid_ = -1;
  rpc::UniqueFd pidfd_;
};

}  // namespace animado
