// animado snapshot: all definitions at one instant, as text.
#include "animado/commands.hpp"
#include "animado/names_file.hpp"
#include "controle/results/output_file.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct SnapshotOptions {
  SuiteChoice suite;
  std::string file, prefix;
};

void snapshot(const SnapshotOptions& options) {
  const std::string text =
      names_text(interexpserv::Client(*connect_to_suite(options.suite)).snapshot(options.prefix));
  options.file.empty() ? fmt::print("{}", text) : controle::write_whole(options.file, text);
}

}  // namespace

void add_snapshot_command(CommandLine& line) {
  const auto options = std::make_shared<SnapshotOptions>();
  CLI::App& command =
      add_command(line, "snapshot", "Keep the definitions of names",
                  "  animado snapshot names.txt                 a line `name = expression` each\n"
                  "  animado snapshot ball.txt --prefix ball    those within ball\n"
                  "  animado snapshot | less\n\n"
                  "animado restore names.txt brings them back.\n");
  command.add_option("file", options->file, "Where to (default: the terminal)")->type_name(kFileType);
  command.add_option("--prefix", options->prefix, "A namespace: ball");
  add_suite_choice(command, options->suite);
  command.callback([options] { snapshot(*options); });
}

}  // namespace animado
