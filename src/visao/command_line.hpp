// The command line of visao, which is that of `animado render` too.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "visao/options.hpp"

namespace animado::visao {

// program: what it is called by. Parsing fills `options`, which must outlive the parser.
std::unique_ptr<CLI::App> command_line(const std::string& program, Options& options);

}  // namespace animado::visao
