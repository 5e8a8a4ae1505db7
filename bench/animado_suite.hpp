// The modules to measure: in this process, or started as processes.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "rpc/channel.hpp"

namespace animado::bench {

std::unique_ptr<rpc::Suite> local_suite();

// The four services as processes of their own, in a temporary directory; they end with this object.
class SocketServices {
 public:
  SocketServices();
  ~SocketServices();
  rpc::Suite& suite() { return *suite_; }

 private:
  std::filesystem::path directory_;
  std::vector<pid_t> processes_;
  std::unique_ptr<rpc::Suite> suite_;
};

}  // namespace animado::bench
