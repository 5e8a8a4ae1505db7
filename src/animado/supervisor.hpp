// Keeps the services of a run alive: starts them, starts again what dies, ends them. One thread, one poll:
// process ends (pidfd) and signals (signalfd) are descriptors like any other, so that nothing races.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "animado/child.hpp"
#include "animado/restart_policy.hpp"
#include "rpc/unique_fd.hpp"

namespace animado {

struct Death {
  std::string service;
  pid_t pid;
  int status;  // what it returned, or 128 + the signal that killed it
};

class Supervisor {
 public:
  // logs: directory of the services' log files; NAME.log takes what NAME prints. From here on SIGINT and
  // SIGTERM are taken as `interrupted`.
  explicit Supervisor(std::filesystem::path logs);
  ~Supervisor();  // ends the services
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  // Starts a service: arguments[0] is its program. Throws Error(unavailable).
  void start(const std::string& name, std::vector<std::string> arguments);

  // Waits until one of `descriptors` is readable, a service dies, a signal comes or the time is over
  // (timeout_ms < 0: never). Starts again what died. Throws Error(unavailable), with the last lines of its
  // log, when a service died too often.
  void wait(std::span<const int> descriptors, int timeout_ms);

  // The logs were moved, as part of a directory that got another name: services that are started again write
  // there.
  void move_logs(const std::filesystem::path& logs);

  int interruptions() const { return interruptions_; }  // SIGINT and SIGTERM so far
  std::function<void(const Death&)> on_death;

  // Ends the services, the last one started first; by force what does not end by itself.
  void stop();

 private:
  struct Service {
    std::string name;
    std::vector<std::string> arguments;
    Child process;
    RestartPolicy policy;
    std::optional<RestartPolicy::Time> restart_at;
  };
  void take_signals();
  void take_death(Service& service);
  void restart_what_is_due();
  int time_to_next_restart_ms(int timeout_ms) const;

  std::filesystem::path logs_;
  rpc::UniqueFd signals_;
  std::vector<Service> services_;
  int interruptions_ = 0;
};

}  // namespace animado
