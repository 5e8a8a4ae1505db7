// What the services of a suite do, as `animado ps` and `animado top` show it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rpc/common.hpp"
#include "rpc/socket_suite.hpp"

namespace animado {

struct ServiceState {
  std::string socket;
  int64_t restarts = 0;
  rpc::Statistics::Reply statistics;
};

// interexpserv first, then those that it knows; one that has gone meanwhile is left out.
std::vector<ServiceState> service_states(rpc::SocketSuite& suite);

// How busy a service was between two looks at it.
struct ServiceLoad {
  std::string service, version, up_since, socket;
  int64_t pid = 0, requests = 0, errors = 0, restarts = 0;      // since it started
  double requests_per_s = 0, p50_us = 0, p99_us = 0, busy = 0;  // in between; busy: 0 … 1
  int64_t queue = 0, connections = 0;                           // now; queue: connections whose requests wait
};

// before: of the same service; null, or another process: since it started.
ServiceLoad load_between(const ServiceState* before, const ServiceState& now);
std::vector<ServiceLoad> loads_between(const std::vector<ServiceState>& before,
                                       const std::vector<ServiceState>& now);

std::string load_table(const std::vector<ServiceLoad>& loads);  // with a heading, a line a service
nlohmann::ordered_json load_json(const std::vector<ServiceLoad>& loads);

}  // namespace animado
