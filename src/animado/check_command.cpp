// animado check: is this scene one that can be simulated?
#include <nlohmann/json.hpp>

#include "animado/commands.hpp"
#include "animado/scene_check.hpp"
#include "console/terminal.hpp"

namespace animado {

namespace {

// For programs: what was checked, or what is wrong with it.
void print_json(const std::string& scene, const Error* error) {
  nlohmann::ordered_json page = {{"scene", scene}, {"ok", error == nullptr}};
  if (error != nullptr) {
    page["error"] = {{"code", name_of(error->code())},
                     {"message", error->message()},
                     {"where", error->where()},
                     {"remedy", error->remedy()}};
  }
  fmt::print("{}\n", page.dump());
}

}  // namespace

void add_check_command(CommandLine& line) {
  struct Options {
    std::vector<std::string> scenes;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      line, "check", "Check scenes without running them",
      "  animado check scenes/colisao.animado\n"
      "  animado check --json scenes/*.animado      an object a line\n\n"
      "Exit code 0 when all are fine, 3 when one is refused: file:line:column, what is wrong, the remedy.\n");
  command.add_option("scene", options->scenes, "Scene files")->required()->type_name(kSceneType);
  command.add_flag("--json", options->json, "An object a scene, a line each");
  command.callback([&line, options] {
    for (const std::string& scene : options->scenes) {
      try {
        check_scene(scene);
        if (options->json) print_json(scene, nullptr);
      } catch (const Error& error) {
        line.exit_code = kRefused;
        if (options->json) {
          print_json(scene, &error);
        } else {
          print_error(error);
        }
      }
    }
  });
}

}  // namespace animado
