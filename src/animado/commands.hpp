// The subcommands of `animado`, one a file. Each adds itself to the program; when it is chosen, its work
// happens during parsing, and what it returns becomes the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "animado/exit_code.hpp"
#include "animado/running_suite.hpp"
#include "console/option_types.hpp"

namespace animado {

struct CommandLine {
  CLI::App app;
  std::vector<std::string> words;  // as they were given
  ExitCode exit_code = kDone;
};

// A subcommand whose --help opens with examples of its use.
CLI::App& add_command(CommandLine& line, const std::string& name, const std::string& description,
                      const std::string& examples);

void add_suite_choice(CLI::App& command, SuiteChoice& choice);  // --run, --socket-dir

void add_run_command(CommandLine& line);
void add_report_command(CommandLine& line);
void add_render_command(CommandLine& line);
void add_check_command(CommandLine& line);
void add_ps_command(CommandLine& line);
void add_top_command(CommandLine& line);
void add_ping_command(CommandLine& line);
void add_get_command(CommandLine& line);
void add_set_command(CommandLine& line);
void add_snapshot_command(CommandLine& line);
void add_restore_command(CommandLine& line);
void add_eval_command(CommandLine& line);
void add_watch_command(CommandLine& line);
void add_integrate_command(CommandLine& line);
void add_call_command(CommandLine& line);
void add_solve_command(CommandLine& line);
void add_protocol_command(CommandLine& line);
void add_log_command(CommandLine& line);
void add_plot_command(CommandLine& line);
void add_completion_command(CommandLine& line);
void add_man_command(CommandLine& line);

}  // namespace animado
