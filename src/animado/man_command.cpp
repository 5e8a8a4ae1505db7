// animado man: the manual pages, for man(1).
#include "animado/commands.hpp"
#include "base/error.hpp"
#include "console/program_manual.hpp"
#include "controle/results/output_file.hpp"

namespace animado {

namespace {

struct ManOptions {
  std::string command, directory;
};

std::string page_name(const CLI::App& command) {
  return "animado-" + command.get_name();
}

const CLI::App& command_named(const CLI::App& program, const std::string& name) {
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == name) return *command;
  }
  throw Error(Code::unknown_name, fmt::format("there is no command '{}'", name), {},
              "animado --help lists them");
}

void write_all(const CLI::App& program, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  controle::write_whole(directory / "animado.1", man_page(program, "animado"));
  for (const CLI::App* command : program.get_subcommands({})) {
    controle::write_whole(directory / (page_name(*command) + ".1"), man_page(*command, page_name(*command)));
  }
}

void print(const CLI::App& program, const ManOptions& options) {
  if (!options.directory.empty()) return write_all(program, options.directory);
  if (options.command.empty()) return fmt::print("{}", man_page(program, "animado"));
  const CLI::App& command = command_named(program, options.command);
  fmt::print("{}", man_page(command, page_name(command)));
}

}  // namespace

void add_man_command(CommandLine& line) {
  const auto options = std::make_shared<ManOptions>();
  CLI::App& command = add_command(line, "man", "Print a manual page",
                                  "  animado man run | man -l -\n"
                                  "  animado man --all build/release/man/man1    all of them, as files\n\n"
                                  "The build makes them: with build/release/bin in PATH, `man animado-run` "
                                  "finds its page.\n");
  command.add_option("command", options->command, "Whose page (default: that of animado)");
  command.add_option("--all", options->directory, "Write all pages into this folder")->type_name(kFolderType);
  command.callback([&line, options] { print(line.app, *options); });
}

}  // namespace animado
