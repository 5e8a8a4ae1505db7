// How a program answers a command line: with what was asked of it, or with what is wrong.
#pragma once

#include <CLI/App.hpp>

#include "base/error.hpp"

namespace animado {

// What is wrong, naming the word that was meant where there is one like it.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

// The exit code of a command line that is not to be run: 0 after --help and its like, which are printed here;
// 2 after an error, which is printed.
int exit_of_parse(const CLI::App& app, const CLI::ParseError& error);

}  // namespace animado
