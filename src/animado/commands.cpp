#include "animado/commands.hpp"

#include "console/program_manual.hpp"

namespace animado {

CLI::App& add_command(CommandLine& line, const std::string& name, const std::string& description,
                      const std::string& examples) {
  CLI::App& command = *line.app.add_subcommand(name, description);
  command.formatter(std::make_shared<ExamplesFirst>(examples));
  return command;
}

void add_suite_choice(CLI::App& command, SuiteChoice& choice) {
  command.add_option("--run", choice.run, "Name of the run (default: the one that started last)");
  command.add_option("--socket-dir", choice.socket_dir, "Directory of the run's sockets")
      ->type_name(kFolderType);
}

}  // namespace animado
