// What an option takes, told from the name of its type, which --help shows too: SCENE, DIR, FILE, or the
// words between braces.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "console/option_types.hpp"

namespace animado {

enum class ValueKind { none, scenes, folders, files, words };

struct Values {
  ValueKind kind = ValueKind::none;
  std::vector<std::string> words = {};
};

Values values_of(const CLI::Option& option);

// Of a command: the options by all their names, with their dashes, or the positionals.
std::vector<const CLI::Option*> positionals_of(const CLI::App& command);
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<std::string> names_of(const CLI::Option& option);
bool takes_value(const CLI::Option& option);

}  // namespace animado
