// The four services as real processes in a directory of their own, ended with this object. Used by the tests
// of the suite and by the benchmarks.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "animado/child.hpp"
#include "rpc/socket_suite.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::suite {

class Services {
 public:
  Services();  // returns when each of them answers
  ~Services();
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  rpc::SocketSuite& suite() { return *suite_; }
  const std::filesystem::path& directory() const { return directory_.path(); }
  std::filesystem::path socket(const std::string& service);
  pid_t pid(const std::string& service) const { return processes_.at(service).pid(); }
  void restart(const std::string& service,
               int signal);  // ends it by the signal; returns when the new one answers
  bool is_running(const std::string& service) const { return !processes_.at(service).wait(0); }

 private:
  void start(const std::string& service);

  TemporaryDirectory directory_;
  std::map<std::string, Child> processes_;
  std::unique_ptr<rpc::SocketSuite> suite_;
};

}  // namespace animado::suite
