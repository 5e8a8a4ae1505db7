// animado: the command line of the suite.
#include "animado/commands.hpp"
#include "animado/terminal.hpp"

int main(int argc, char** argv) {
  using namespace animado;
  CommandLine line;
  line.app.description("ANIMADO: rigid bodies in motion, simulated by five programs.");
  line.app.require_subcommand(1);
  line.app.set_version_flag("--version", ANIMADO_VERSION);
  for (const auto add : {add_run_command, add_render_command, add_report_command, add_check_command,
                         add_ps_command, add_top_command, add_ping_command, add_get_command, add_set_command,
                         add_snapshot_command, add_restore_command, add_eval_command, add_watch_command,
                         add_solve_command, add_integrate_command, add_call_command, add_protocol_command}) {
    add(line);
  }
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return line.app.exit(error) == 0 ? kDone : kUsage;
  } catch (const Error& error) {
    print_error(error);
    return exit_code_of_call(error.code());
  }
  return line.exit_code;
}
