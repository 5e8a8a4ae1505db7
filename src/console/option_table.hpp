// What a program's table of options holds: for its completion, and for what is said of a mistyped word.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace animado {

std::vector<const CLI::Option*> positionals_of(const CLI::App& command);
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<std::string> names_of(const CLI::Option& option);  // all of them, with their dashes
bool takes_value(const CLI::Option& option);

std::vector<std::string> commands_of(const CLI::App& program);  // by name

}  // namespace animado
