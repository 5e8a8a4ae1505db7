// animado top: what the services do now, drawn again each second.
#include <poll.h>

#include "animado/commands.hpp"
#include "animado/screen.hpp"
#include "animado/service_load.hpp"

namespace animado {

namespace {

struct TopOptions {
  SuiteChoice suite;
  double every_s = 1;
  bool once = false, json = false;
};

void show_once(const TopOptions& options, rpc::SocketSuite& suite) {
  const auto before = service_states(suite);
  poll(nullptr, 0, static_cast<int>(1000 * options.every_s));
  const auto loads = loads_between(before, service_states(suite));
  options.json ? fmt::print("{}\n", load_json(loads).dump()) : fmt::print("{}", load_table(loads));
}

void show_until_told(const TopOptions& options, rpc::SocketSuite& suite) {
  Screen screen;
  std::vector<ServiceState> before;  // at first what there was since the start is shown
  do {
    auto now = service_states(suite);
    screen.draw(fmt::format("animado top   {}   every {} s   q ends\n\n{}",
                            suite.options().directory.string(), options.every_s,
                            load_table(loads_between(before, now))));
    before = std::move(now);
  } while (screen.wait(options.every_s));
}

}  // namespace

void add_top_command(CommandLine& line) {
  const auto options = std::make_shared<TopOptions>();
  CLI::App& command =
      add_command(line, "top", "Show what the services do, drawn again each second",
                  "  animado top            until q or Ctrl-C\n"
                  "  animado top --once     one plain table, as when its output is no terminal\n"
                  "  animado top --json     the same for programs\n\n"
                  "REQ/S, P50, P99 (from arrival to answer) and BUSY % are of the last second;\n"
                  "QUEUE is the connections whose requests wait.\n");
  command.add_option("--every", options->every_s, "Seconds between two looks")
      ->check(CLI::Range(0.01, 3600.0));
  command.add_flag("--once", options->once, "One table");
  command.add_flag("--json", options->json, "A list of objects, once");
  add_suite_choice(command, options->suite);
  command.callback([options] {
    const auto suite = connect_to_suite(options->suite);
    const bool is_live = !options->once && !options->json && Screen::is_possible();
    is_live ? show_until_told(*options, *suite) : show_once(*options, *suite);
  });
}

}  // namespace animado
