// animado set: defines names by expressions, while a run is going.
#include "animado/commands.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct SetOptions {
  SuiteChoice suite;
  std::vector<std::string> words;
  std::optional<int64_t> if_version;
};

void set(const SetOptions& options) {
  const auto& words = options.words;
  if (words.size() % 2 != 0) throw CLI::ValidationError("set", "each name needs an expression");
  std::vector<interexpserv::Define::Definition> definitions;
  for (size_t i = 0; i < words.size(); i += 2) definitions.push_back({words[i], words[i + 1]});
  std::vector<interexpserv::Expected> expected;
  if (options.if_version) expected.push_back({words[0], *options.if_version});
  interexpserv::Client(*connect_to_suite(options.suite)).define(std::move(definitions), std::move(expected));
}

}  // namespace

void add_set_command(CommandLine& line) {
  const auto options = std::make_shared<SetOptions>();
  CLI::App& command =
      add_command(line, "set", "Define names by expressions",
                  "  animado set ball.force \"(0, -9.81*mass, 0)\"\n"
                  "  animado set spring.k \"4*pi^2*ball.mass\" spring.x0 0.5    both or none\n"
                  "  animado set spring.k 5 --if-version 12    nothing if somebody was faster\n\n"
                  "A run takes the change at its next frame, and writes it down in events.jsonl.\n");
  command.add_option("name expression", options->words, "Names, each with its expression")->required();
  add_suite_choice(command, options->suite);
  command.add_option("--if-version", options->if_version,
                     "Only if the first name has this version (animado get --json); 0: if it is not there");
  command.callback([options] { set(*options); });
}

}  // namespace animado
