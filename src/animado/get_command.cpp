// animado get: what names stand for now.
#include "animado/commands.hpp"
#include "animado/running_suite.hpp"
#include "animado/value_text.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct Options {
  SuiteChoice suite;
  std::vector<std::string> names;
  bool json = false;
};

void get(const Options& options) {
  const auto suite = connect_to_suite(options.suite);
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
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(line, "get", "Show the values of names",
                                  "  animado get ball.position          its value alone\n"
                                  "  animado get ball.position spring.k\n"
                                  "  animado get                        all names\n");
  command.add_option("name", options->names, "Names (default: all)");
  command.add_flag("--json", options->json, "An object a name, a line each");
  add_suite_choice(command, options->suite);
  command.callback([options] { get(*options); });
}

}  // namespace animado
