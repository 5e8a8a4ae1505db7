#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "animado/completion.hpp"
#include "animado/completion_values.hpp"
#include "console/option_table.hpp"

namespace animado {

namespace {

using Words = std::vector<std::string>;

constexpr auto kBashHead = R"(# Completion of animado for bash: source <(animado completion bash)
_animado() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=
  local options= valued= kind= i index=0
  local -a positionals=()
  [ "$COMP_CWORD" -lt 2 ] || command=${COMP_WORDS[1]}
  case $command in
)";

// Which positional is it? Words that an option takes do not count. The last positional takes all that follow.
constexpr auto kBashTail = R"(    *) return ;;
  esac
  for ((i = 2; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in
      -*) [[ " $valued " != *" ${COMP_WORDS[i]} "* ]] || i=$((i + 1)) ;;
      *) index=$((index + 1)) ;;
    esac
  done
  [ "$index" -lt "${#positionals[@]}" ] || index=$((${#positionals[@]} - 1))
  if [[ " $valued " != *" $before "* ]]; then
    [ "$index" -lt 0 ] || kind=${positionals[index]}
    [[ $word != -* ]] || kind="words $options"
  fi
  COMPREPLY=()
  case $kind in
    scenes)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.animado' -- "$word") ;;
    folders)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    files)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    words*) mapfile -t COMPREPLY < <(compgen -W "${kind#words}" -- "$word") ;;
  esac
}
complete -F _animado animado
)";

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

std::string kind_text(const Values& values) {
  switch (values.kind) {
    case ValueKind::none:
      return "none";
    case ValueKind::scenes:
      return "scenes";
    case ValueKind::folders:
      return "folders";
    case ValueKind::files:
      return "files";
    case ValueKind::words:
      return fmt::format("words {}", fmt::join(values.words, " "));
  }
  return "none";
}

// The branch of a command: its options, which of them take a value and of which kind, its positionals.
std::string branch(const std::string& command, const CLI::App& app, const Words& positionals) {
  Words options, valued;
  std::string kinds;
  for (const CLI::Option* option : options_of(app)) {
    const Words names = names_of(*option);
    options.insert(options.end(), names.begin(), names.end());
    if (!takes_value(*option)) continue;
    valued.insert(valued.end(), names.begin(), names.end());
    kinds += fmt::format("        {}) kind={} ;;\n", fmt::join(names, " | "),
                         quoted(kind_text(values_of(*option))));
  }
  std::string text = fmt::format("    {})\n      options={} valued={}\n", command,
                                 quoted(fmt::format("{}", fmt::join(options, " "))),
                                 quoted(fmt::format("{}", fmt::join(valued, " "))));
  if (!positionals.empty()) text += fmt::format("      positionals=({})\n", fmt::join(positionals, " "));
  if (!kinds.empty()) text += "      case $before in\n" + kinds + "      esac\n";
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string text =
      kBashHead + branch("''", program, {quoted(kind_text({ValueKind::words, commands_of(program)}))});
  for (const CLI::App* command : program.get_subcommands({})) {
    Words positionals;
    for (const CLI::Option* option : positionals_of(*command))
      positionals.push_back(quoted(kind_text(values_of(*option))));
    // Another program has its options; what it is given first is a folder.
    if (command->get_prefix_command()) positionals.push_back(quoted(kind_text({ValueKind::folders})));
    text += branch(command->get_name(), *command, positionals);
  }
  return text + kBashTail;
}

}  // namespace animado
