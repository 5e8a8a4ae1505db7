// What a shell needs to complete the command line: commands, options, and values by their kind. Made from the
// same tables of options as --help.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace animado {

// Scripts that define how the program is completed; bash and zsh source them.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace animado
