// animado call: any message of any service, as JSON.
#include <iostream>
#include <iterator>

#include "animado/commands.hpp"

namespace animado {

namespace {

constexpr auto kCallExamples =
    "  animado call egesp solve '{\"matrices\": {\"shape\": [2, 2], \"data\": [2, 1, 1, 3]},\n"
    "                             \"right_sides\": {\"shape\": [2], \"data\": [3, 5]}}'\n"
    "  animado call fred methods\n"
    "  animado call interexpserv describe                what it can be asked\n"
    "  animado call fred integrate - < request.json      the request from stdin\n\n"
    "The reply is JSON on stdout. docs/protocol.md lists the messages.\n";

struct CallOptions {
  SuiteChoice suite;
  std::string service, method, params = "{}";
};

}  // namespace

void add_call_command(CommandLine& line) {
  const auto options = std::make_shared<CallOptions>();
  CLI::App& command = add_command(line, "call", "Send a message to a service", kCallExamples);
  command.add_option("service", options->service, "interexpserv, egesp, fred or colisao")->required();
  command.add_option("method", options->method, "The message")->required();
  command.add_option("params", options->params, "Its fields as a JSON object; - reads stdin (default: {})");
  add_suite_choice(command, options->suite);
  command.callback([options] {
    const std::string params =
        options->params == "-" ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : options->params;
    const auto suite = connect_to_suite(options->suite);
    fmt::print("{}\n", suite->channel(options->service).call_json(options->method, params));
  });
}

}  // namespace animado
