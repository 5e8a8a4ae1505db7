// animado ps: the services of a suite.
#include <nlohmann/json.hpp>

#include "animado/commands.hpp"
#include "animado/running_suite.hpp"
#include "base/error.hpp"
#include "interexpserv/client.hpp"
#include "rpc/common.hpp"
#include "rpc/endpoint.hpp"

namespace animado {

namespace {

struct Options {
  SuiteChoice suite;
  bool json = false;
};

struct Row {
  std::string socket;
  rpc::Statistics::Reply statistics;
};

// interexpserv first, then those that it knows.
std::vector<Row> rows(rpc::SocketSuite& suite) {
  const std::string well_known(rpc::kWellKnown);
  std::vector<Row> found = {{rpc::socket_path(suite.options().directory, well_known, 0),
                             suite.channel(well_known).call<rpc::Statistics>({})}};
  for (const auto& service : interexpserv::Client(suite).services()) {
    if (service.name == well_known) continue;
    try {
      found.push_back({service.socket, suite.channel(service.name).call<rpc::Statistics>({})});
    } catch (const Error& error) {
      if (error.code() != Code::unavailable) throw;  // it has gone since
    }
  }
  return found;
}

void print_table(const std::vector<Row>& found) {
  fmt::print("{:<13} {:>8} {:<8} {:<28} {:>10} {:>7}  {}\n", "SERVICE", "PID", "VERSION", "UP SINCE",
             "REQUESTS", "ERRORS", "SOCKET");
  for (const auto& [socket, s] : found) {
    fmt::print("{:<13} {:>8} {:<8} {:<28} {:>10} {:>7}  {}\n", s.service, s.pid, s.version, s.up_since,
               s.requests, s.errors, socket);
  }
}

void print_json(const std::vector<Row>& found) {
  auto page = nlohmann::ordered_json::array();
  for (const auto& [socket, s] : found) {
    page.push_back({{"service", s.service},
                    {"pid", s.pid},
                    {"version", s.version},
                    {"socket", socket},
                    {"up_since", s.up_since},
                    {"requests", s.requests},
                    {"errors", s.errors}});
  }
  fmt::print("{}\n", page.dump());
}

}  // namespace

void add_ps_command(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(line, "ps", "List the services that run",
                                  "  animado ps                     of the suite that was started last\n"
                                  "  animado ps --run colisao-4711\n");
  command.add_flag("--json", options->json, "A list of objects");
  add_suite_choice(command, options->suite);
  command.callback([options] {
    const auto suite = connect_to_suite(options->suite);
    options->json ? print_json(rows(*suite)) : print_table(rows(*suite));
  });
}

}  // namespace animado
