// animado render: becomes visao, which knows the options and says them under this command's name.
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "animado/commands.hpp"
#include "animado/programs.hpp"
#include "base/error.hpp"

namespace animado {

namespace {

[[noreturn]] void become_visao(std::vector<std::string> options) {
  const std::string visao = program("visao");
  std::string name = "animado render";
  std::vector<char*> raw = {name.data()};
  for (std::string& option : options) raw.push_back(option.data());
  raw.push_back(nullptr);
  execv(visao.c_str(), raw.data());
  throw Error(Code::unavailable, "cannot start " + visao + ": " + std::strerror(errno), "",
              "build it: scripts/build release programs");
}

}  // namespace

void add_render_command(CommandLine& line) {
  CLI::App& command = *line.app.add_subcommand("render", "Pictures and films of a run");
  command.prefix_command();
  command.set_help_flag();
  command.callback([&command] { become_visao(command.remaining()); });
}

}  // namespace animado
