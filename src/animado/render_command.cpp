// animado render: becomes visao, once the command line makes sense.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "animado/commands.hpp"
#include "animado/programs.hpp"
#include "base/error.hpp"
#include "visao/command_line.hpp"

namespace animado {

namespace {

constexpr auto kName = "render";

// words: of animado's command line.
[[noreturn]] void become_visao(std::vector<std::string> words) {
  std::string visao = program("visao");
  std::vector<char*> raw = {visao.data()};
  for (auto word = std::ranges::find(words, kName) + 1; word != words.end(); ++word)
    raw.push_back(word->data());
  raw.push_back(nullptr);
  execv(visao.c_str(), raw.data());
  throw Error(Code::unavailable, "cannot start " + visao + ": " + std::strerror(errno), "",
              "build it: scripts/build release programs");
}

}  // namespace

void add_render_command(CommandLine& line) {
  const auto options = std::make_shared<visao::Options>();
  CLI::App& command =
      add_command(line, kName, "Pictures and films of a run", visao::examples("animado render"));
  visao::add_options(command, *options);
  command.callback([&line, options] { become_visao(line.words); });
}

}  // namespace animado
