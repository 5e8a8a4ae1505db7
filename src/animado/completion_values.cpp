#include "animado/completion_values.hpp"

#include <CLI/CLI.hpp>

namespace animado {

Values values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const size_t open = type.find('{'), close = type.find('}');
  if (open < close && close != type.npos)
    return {ValueKind::words, CLI::detail::split(type.substr(open + 1, close - open - 1), ',')};
  const auto is = [&](const std::string& name) { return type == name || type.ends_with(":" + name); };
  if (is(kSceneType)) return {ValueKind::scenes};
  if (is(kFolderType)) return {ValueKind::folders};
  if (is(kFileType)) return {ValueKind::files};
  return {};
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

}  // namespace animado
