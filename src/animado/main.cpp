// animado: the command line of the suite.
#include "animado/commands.hpp"
#include "console/output.hpp"
#include "console/program_manual.hpp"
#include "console/terminal.hpp"
#include "console/usage_error.hpp"

namespace {

using namespace animado;

constexpr auto kExamples =
    "  animado run scenes/colisao.animado              results in runs/colisao/\n"
    "  animado plot runs/colisao energy cubo.y         curves of a run\n"
    "  animado eval \"norm((3, 4, 0))\"                  the language of scenes\n"
    "  animado run --help                              examples and options of a command\n";

int run(int argc, char** argv) {
  CommandLine line;
  line.app.description("ANIMADO: rigid bodies in motion, simulated by five programs.");
  line.app.name("animado");
  line.app.formatter(std::make_shared<ExamplesFirst>(kExamples));
  line.app.require_subcommand(1);
  line.app.set_version_flag("--version", ANIMADO_VERSION);
  for (const auto add :
       {add_run_command,   add_render_command,   add_report_command,   add_plot_command,
        add_check_command, add_ps_command,       add_top_command,      add_ping_command,
        add_get_command,   add_set_command,      add_snapshot_command, add_restore_command,
        add_eval_command,  add_watch_command,    add_solve_command,    add_integrate_command,
        add_call_command,  add_protocol_command, add_log_command,      add_completion_command,
        add_man_command}) {
    add(line);
  }
  line.words.assign(argv + 1, argv + argc);
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_of_parse(line.app, error);
  } catch (const Error& error) {
    print_error(error);
    return exit_code_of_call(error.code());
  }
  return line.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  return with_output([&] { return run(argc, argv); });
}
