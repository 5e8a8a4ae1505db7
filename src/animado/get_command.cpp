// animado get: what names stand for now.
#include "animado/commands.hpp"
#include "animado/value_text.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct GetOptions {
  SuiteChoice suite;
  std::vector<std::string> names;
  bool json = false, history = false;
};

void print_history(const GetOptions& options, rpc::SocketSuite& suite) {
  for (const std::string& name : options.names) {
    for (const auto& r : interexpserv::Client(suite).history(name)) {
      if (options.json) {
        const nlohmann::ordered_json page = {
            {"name", name}, {"version", r.version}, {"time", r.time}, {"who", r.who}, {"text", r.text}};
        fmt::print("{}\n", page.dump());
      } else {
        const bool removed = r.kind == interexpserv::Kind::removed;
        fmt::print("{} {:>6} {:<12} {} {}\n", r.time, r.version, r.who.empty() ? "-" : r.who, name,
                   removed ? "is removed" : "= " + r.text);
      }
    }
  }
}

void get(const GetOptions& options) {
  const auto suite = connect_to_suite(options.suite);
  if (options.history) return print_history(options, *suite);
  rpc::Channel& interexpserv = suite->channel("interexpserv");
  for (const auto& name : interexpserv.call<interexpserv::Get>({options.names, {}}).names) {
    const std::string value = value_text(name.type, name.values);
    if (options.json) {
      fmt::print("{}\n", name_json(name).dump());
    } else if (options.names.size() == 1) {
      fmt::print("{}\n", value);
    } else {
      fmt::print("{} = {}{}\n", name.name, value,
                 name.text.empty() || name.text == value ? "" : "   # " + name.text);
    }
  }
}

}  // namespace

void add_get_command(CommandLine& line) {
  const auto options = std::make_shared<GetOptions>();
  CLI::App& command = add_command(line, "get", "Show the values of names",
                                  "  animado get ball.position          its value alone\n"
                                  "  animado get ball.position spring.k\n"
                                  "  animado get                        all names\n"
                                  "  animado get spring.k --history     who made it what, and when\n");
  CLI::Option* name = command.add_option("name", options->names, "Names (default: all)");
  command.add_flag("--json", options->json, "An object a name, a line each");
  command.add_flag("--history", options->history, "What each name was made to stand for, oldest first")
      ->needs(name);
  add_suite_choice(command, options->suite);
  command.callback([options] { get(*options); });
}

}  // namespace animado
