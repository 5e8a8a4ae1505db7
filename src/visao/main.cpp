// visao: pictures and films of a run, from its results folder.
#include "console/output.hpp"
#include "console/program_manual.hpp"
#include "console/terminal.hpp"
#include "console/usage_error.hpp"
#include "visao/command_line.hpp"

namespace {

using namespace animado;

int run(int argc, char** argv) {
  constexpr int kUsage = 2;
  visao::Options options;
  CLI::App app("Pictures and films of a run", "visao");
  app.set_version_flag("--version", ANIMADO_VERSION);
  add_manual(app, "visao", visao::examples("visao"));
  visao::add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_of_parse(app, error);
  }
  try {
    return visao::render(options);
  } catch (const Error& error) {
    print_error(error);
    return kUsage;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return with_output([&] { return run(argc, argv); });
}
