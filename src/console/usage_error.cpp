#include "console/usage_error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "base/nearest_name.hpp"
#include "console/option_table.hpp"
#include "console/terminal.hpp"

namespace animado {
namespace {

const CLI::App& asked_of(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : asked_of(*commands.front());
}

std::string full_name(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return parent ? full_name(*parent) + ' ' + app.get_name() : app.get_name();
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(app))
    std::ranges::move(names_of(*option), std::back_inserter(names));
  return names;
}

Error unexpected(const CLI::App& app, const std::string& word) {
  const bool is_option = word.starts_with('-');
  const auto commands = commands_of(app), known = is_option ? option_names(app) : commands;
  const std::string meant = nearest_name(word, known);
  const std::string what = is_option          ? fmt::format("there is no option `{}`", word)
                           : commands.empty() ? fmt::format("`{}` is a word too many", word)
                                              : fmt::format("there is no command `{}`", word);
  return {Code::bad_params, what, "",
          meant.empty() ? fmt::format("`{} --help` lists what there is", full_name(app))
                        : fmt::format("did you mean `{}`?", meant)};
}

}  // namespace

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& asked = asked_of(app);
  const auto rest = app.remaining(true);
  if (!rest.empty()) return unexpected(asked, rest.front());
  return {Code::bad_params, error.what(), "",
          fmt::format("`{} --help` tells how it is called", full_name(asked))};
}

int exit_of_parse(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  print_error(usage_error(app, error));
  return 2;
}

}  // namespace animado
