#include "animado/commands.hpp"

#include "console/program_manual.hpp"

namespace animado {

CLI::App& add_command(CommandLine& line, const std::string& name, const std::string& description,
                      const std::string& examples) {
  CLI::App& command = *line.app.add_subcommand(name, description);
  command.formatter(std::make_shared<ExamplesFirst>(examples));
  return command;
}

}  // namespace animado
