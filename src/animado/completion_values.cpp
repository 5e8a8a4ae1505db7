#include "animado/completion_values.hpp"

#include <CLI/CLI.hpp>

#include "console/option_types.hpp"

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

}  // namespace animado
