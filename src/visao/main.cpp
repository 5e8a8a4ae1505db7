// visao: pictures and films of a run, from its results folder. `animado render` starts it under its own name.
#include "visao/command_line.hpp"
#include "visao/console.hpp"

int main(int argc, char** argv) {
  using namespace animado;
  constexpr int kUsage = 2;
  visao::Options options;
  const std::string called = argv[0];
  const auto app = visao::command_line(called == "animado render" ? called : "visao", options);
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app->exit(error) == 0 ? 0 : kUsage;
  }
  try {
    return visao::render(options);
  } catch (const Error& error) {
    visao::print_error(error);
    return kUsage;
  }
}
