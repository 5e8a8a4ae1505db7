// animado eval: the value of an expression, with the names of the suite that runs, if one does.
#include "animado/commands.hpp"
#include "animado/value_text.hpp"
#include "interexpserv/client.hpp"
#include "interexpserv/program.hpp"

namespace animado {

namespace {

struct EvalOptions {
  SuiteChoice suite;
  std::string text;
  bool json = false;
};

interexpserv::Evaluate::Reply evaluate(const EvalOptions& options) {
  if (const auto suite = find_suite(options.suite))
    return interexpserv::Client(*suite).evaluate(options.text);
  if (!options.suite.run.empty() || !options.suite.socket_dir.empty())
    connect_to_suite(options.suite);  // says what is missing
  const interexpserv::Program program = interexpserv::compile(options.text, interexpserv::MapScope());
  const interexpserv::Value value = program.constant();
  return {value.type, {value.v.begin(), value.v.begin() + width_of(value.type)}};
}

}  // namespace

void add_eval_command(CommandLine& line) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App& command =
      add_command(line, "eval", "Evaluate an expression",
                  "  animado eval \"2*pi\"\n"
                  "  animado eval \"norm(ball.velocity)^2 * ball.mass / 2\"    while a run is going\n");
  command.add_option("expression", options->text, "The expression (docs/expressions.md)")->required();
  command.add_flag("--json", options->json, "The value as JSON");
  add_suite_choice(command, options->suite);
  command.callback([options] {
    const auto reply = evaluate(*options);
    fmt::print("{}\n", options->json ? value_json(reply.type, reply.values).dump()
                                     : value_text(reply.type, reply.values));
  });
}

}  // namespace animado
