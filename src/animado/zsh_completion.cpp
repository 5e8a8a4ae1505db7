#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "animado/completion.hpp"
#include "animado/completion_values.hpp"
#include "console/option_table.hpp"

namespace animado {

namespace {

constexpr auto kZshHead = R"(#compdef animado
# Completion of animado for zsh: source <(animado completion zsh), or keep it as _animado in a folder of $fpath.
_animado() {
  local -a commands
)";

constexpr auto kZshTail = R"(  esac
}
if [ "${funcstack[1]}" = _animado ]; then _animado "$@"; else compdef _animado animado; fi
)";

// Between single quotes, where _arguments and _describe read colons and brackets as signs of their own.
std::string described(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      if (c == ':' || c == '[' || c == ']' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out;
}

std::string action(const Values& values) {
  switch (values.kind) {
    case ValueKind::none:
      return " ";
    case ValueKind::scenes:
      return "_files -g \"*.animado\"";
    case ValueKind::folders:
      return "_files -/";
    case ValueKind::files:
      return "_files";
    case ValueKind::words:
      return fmt::format("({})", fmt::join(values.words, " "));
  }
  return " ";
}

std::string arguments(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : options_of(command)) {
    const std::string about = described(option->get_description());
    for (const std::string& name : names_of(*option)) {
      const std::string value =
          takes_value(*option) ? fmt::format(":value:{}", action(values_of(*option))) : "";
      text += fmt::format(" \\\n        '{}[{}]{}'", name, about, value);
    }
  }
  // Another program has its options; what it is given first is a folder.
  if (command.get_prefix_command())
    text += fmt::format(" \\\n        '*:directory:{}'", action({ValueKind::folders}));
  const auto positionals = positionals_of(command);
  for (size_t i = 0; i < positionals.size(); ++i) {
    const std::string place = i + 1 == positionals.size() ? "*" : fmt::to_string(i + 1);
    text += fmt::format(" \\\n        '{}:{}:{}'", place, described(positionals[i]->get_name()),
                        action(values_of(*positionals[i])));
  }
  return text;
}

}  // namespace

std::string zsh_completion(const CLI::App& program) {
  std::string text = kZshHead;
  text += "  commands=(\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    text += fmt::format("    '{}:{}'\n", command->get_name(), described(command->get_description()));
  }
  text +=
      "  )\n  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  shift words\n  ((CURRENT--))\n  case $words[1] in\n";
  for (const CLI::App* command : program.get_subcommands({}))
    text += fmt::format("    {})\n      _arguments -s{} ;;\n", command->get_name(), arguments(*command));
  return text + kZshTail;
}

}  // namespace animado
