// The skeleton of a program that serves a table: options, signals, loop, registration, log. A daemon's main
// says its name, its manual and its table, and nothing else.
#pragma once

#include <functional>
#include <string>

#include "rpc/service.hpp"

namespace CLI {
class App;
}

namespace animado::rpc {

struct DaemonInfo {
  std::string name;
  std::string manual;                               // a paragraph for --help
  std::string example;                              // a command line that shows its use
  std::function<void(CLI::App&)> add_options = {};  // options of its own, if any
};

// Serves until SIGTERM or SIGINT. `table` is called once the options are read. The daemon named interexpserv
// listens at the well-known address; the others register with it. Exit codes: 0 ended as asked, 1 could not
// start, 2 usage.
int run_daemon(int argc, char** argv, const DaemonInfo& info,
               const std::function<void(Service&, Suite&)>& table);

}  // namespace animado::rpc
