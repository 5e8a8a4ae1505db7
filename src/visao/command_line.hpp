// The options of visao, which are those of `animado render`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "visao/options.hpp"

namespace animado::visao {

void add_options(CLI::App& app, Options& options);

// What opens --help. program: as the user calls it.
std::string examples(const std::string& program);

}  // namespace animado::visao
