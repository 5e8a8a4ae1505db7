#include "animado/service_load.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "interexpserv/client.hpp"
#include "rpc/endpoint.hpp"
#include "rpc/histogram.hpp"

namespace animado {

namespace {

std::string time_text(double us) {
  if (us < 1000) return fmt::format("{:.3g} µs", us);
  if (us < 1e6) return fmt::format("{:.3g} ms", us / 1e3);
  return fmt::format("{:.3g} s", us / 1e6);
}

}  // namespace

std::vector<ServiceState> service_states(rpc::SocketSuite& suite) {
  const std::string well_known(rpc::kWellKnown);
  std::vector<ServiceState> states = {{rpc::socket_path(suite.options().directory, well_known, 0), 0,
                                       suite.channel(well_known).call<rpc::Statistics>({})}};
  for (const auto& service : interexpserv::Client(suite).services()) {
    if (service.name == well_known) continue;
    try {
      states.push_back({service.socket, service.restarts,
                        suite.server(service.name, service.socket).call<rpc::Statistics>({})});
    } catch (const Error& error) {
      if (error.code() != Code::unavailable) throw;
    }
  }
  return states;
}

ServiceLoad load_between(const ServiceState* before, const ServiceState& now) {
  const rpc::Statistics::Reply nothing, &new_ = now.statistics;
  const bool is_same = before != nullptr && before->statistics.pid == new_.pid;
  const rpc::Statistics::Reply& old = is_same ? before->statistics : nothing;
  const auto latency = rpc::since(new_.latency, old.latency);
  const double time_s = std::max(new_.up_s - old.up_s, 1e-9);
  return {.service = new_.service,
          .version = new_.version,
          .up_since = new_.up_since,
          .socket = now.socket,
          .pid = new_.pid,
          .requests = new_.requests,
          .errors = new_.errors,
          .restarts = now.restarts,
          .requests_per_s = static_cast<double>(new_.requests - old.requests) / time_s,
          .p50_us = rpc::quantile_us(latency, 0.5),
          .p99_us = rpc::quantile_us(latency, 0.99),
          .busy = (new_.busy_s - old.busy_s) / time_s,
          .queue = new_.waiting,
          .connections = new_.connections};
}

std::vector<ServiceLoad> loads_between(const std::vector<ServiceState>& before,
                                       const std::vector<ServiceState>& now) {
  std::vector<ServiceLoad> loads;
  for (const ServiceState& state : now) {
    const auto old = std::ranges::find(before, state.socket, &ServiceState::socket);
    loads.push_back(load_between(old == before.end() ? nullptr : &*old, state));
  }
  return loads;
}

std::string load_table(const std::vector<ServiceLoad>& loads) {
  std::string table =
      fmt::format("{:<13} {:>8} {:>9} {:>8} {:>8} {:>6} {:>6} {:>5} {:>9} {:>10} {:>7}\n", "SERVICE", "PID",
                  "REQ/S", "P50", "P99", "BUSY %", "QUEUE", "CONN", "RESTARTS", "REQUESTS", "ERRORS");
  for (const ServiceLoad& l : loads) {
    table += fmt::format("{:<13} {:>8} {:>9.0f} {:>8} {:>8} {:>6.1f} {:>6} {:>5} {:>9} {:>10} {:>7}\n",
                         l.service, l.pid, l.requests_per_s, time_text(l.p50_us), time_text(l.p99_us),
                         100 * l.busy, l.queue, l.connections, l.restarts, l.requests, l.errors);
  }
  return table;
}

nlohmann::ordered_json load_json(const std::vector<ServiceLoad>& loads) {
  auto page = nlohmann::ordered_json::array();
  for (const ServiceLoad& l : loads) {
    page.push_back({{"service", l.service},
                    {"pid", l.pid},
                    {"version", l.version},
                    {"socket", l.socket},
                    {"up_since", l.up_since},
                    {"requests", l.requests},
                    {"errors", l.errors},
                    {"restarts", l.restarts},
                    {"requests_per_s", l.requests_per_s},
                    {"p50_us", l.p50_us},
                    {"p99_us", l.p99_us},
                    {"busy", l.busy},
                    {"queue", l.queue},
                    {"connections", l.connections}});
  }
  return page;
}

}  // namespace animado
