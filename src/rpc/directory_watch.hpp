// Waits for a socket to appear in the folder: how a client learns, without asking again and again, that a
// service came back.
#pragma once

#include <filesystem>

#include "rpc/unique_fd.hpp"

namespace animado::rpc {

class DirectoryWatch {
 public:
  explicit DirectoryWatch(const std::filesystem::path& directory);
  int fd() const { return fd_.get(); }  // readable when something appeared
  void clear();                         // forgets what appeared so far

 private:
  UniqueFd fd_;
};

}  // namespace animado::rpc
