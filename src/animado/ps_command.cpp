// animado ps: the services of a suite, and what they have done since they started.
#include "animado/commands.hpp"
#include "animado/service_load.hpp"

namespace animado {

namespace {

struct PsOptions {
  SuiteChoice suite;
  bool json = false;
};

}  // namespace

void add_ps_command(CommandLine& line) {
  const auto options = std::make_shared<PsOptions>();
  CLI::App& command =
      add_command(line, "ps", "List the services that run",
                  "  animado ps                     of the suite that was started last\n"
                  "  animado ps --run colisao-4711\n\n"
                  "Averages since each service started; animado top shows what it does now.\n");
  command.add_flag("--json", options->json, "A list of objects");
  add_suite_choice(command, options->suite);
  command.callback([options] {
    const auto loads = loads_between({}, service_states(*connect_to_suite(options->suite)));
    options->json ? fmt::print("{}\n", load_json(loads).dump()) : fmt::print("{}", load_table(loads));
  });
}

}  // namespace animado
