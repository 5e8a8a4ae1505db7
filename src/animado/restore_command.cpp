// animado restore: makes the definitions those of a snapshot.
#include <fstream>

#include "animado/commands.hpp"
#include "animado/names_file.hpp"
#include "base/error.hpp"
#include "console/terminal.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct RestoreOptions {
  SuiteChoice suite;
  std::string file, prefix;
};

std::string text_of(const std::string& file) {
  std::ifstream opened(file);
  if (!opened) throw Error(Code::refused, "cannot be read", file, "give a file that animado snapshot wrote");
  return {std::istreambuf_iterator<char>(opened), {}};
}

void restore(const RestoreOptions& options) {
  const auto suite = connect_to_suite(options.suite);
  const auto done =
      interexpserv::Client(*suite).restore(names_in(text_of(options.file), options.file), options.prefix);
  print_note(fmt::format("{} {} changed", done.changed, done.changed == 1 ? "name" : "names"));
}

}  // namespace

void add_restore_command(CommandLine& line) {
  const auto options = std::make_shared<RestoreOptions>();
  CLI::App& command =
      add_command(line, "restore", "Make the definitions of names those of a snapshot",
                  "  animado restore names.txt\n"
                  "  animado restore ball.txt --prefix ball\n\n"
                  "All of it or nothing: what differs is defined anew, what the file does not have is\n"
                  "removed, live names stay.\n");
  command.add_option("file", options->file, "A file that animado snapshot wrote")
      ->required()
      ->type_name(kFileType);
  command.add_option("--prefix", options->prefix, "The namespace of that snapshot");
  add_suite_choice(command, options->suite);
  command.callback([options] { restore(*options); });
}

}  // namespace animado
