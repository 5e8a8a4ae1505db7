#include "animado/watch_run.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "animado/running_suite.hpp"
#include "console/terminal.hpp"
#include "controle/scene/scene.hpp"
#include "interexpserv/client.hpp"
#include "report/page.hpp"

namespace animado {

std::unique_ptr<live::Watch> watch_run(const RunRequest& request, uint16_t port) {
  const auto edit = [run = request.name](const std::string& name, const std::string& text) {
    interexpserv::Client(*connect_to_suite({.run = run, .socket_dir = {}})).set(name, text);
  };
  auto watch = std::make_unique<live::Watch>(
      live::Watched{controle::read_scene(request.scene), request.directory, report::live_page(), port, edit});
  print_note("watch it at " + watch->address() + "; it begins when the page is open");
  return watch;
}

void end_watch(live::Watch& watch, const std::filesystem::path& results) {
  std::ifstream file(results / "summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  const bool is_whole = summary.is_object();
  watch.end(is_whole ? summary.value("status", "") : "lost", is_whole ? summary.value("state_hash", "") : "");
}

}  // namespace animado
