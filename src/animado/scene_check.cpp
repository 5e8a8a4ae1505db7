#include "animado/scene_check.hpp"

#include "animado/in_process.hpp"
#include "controle/overlap.hpp"

namespace animado {

controle::Scene check_scene(const std::string& path) {
  controle::Scene scene = controle::read_scene(path);
  const auto suite = suite_in_process();
  controle::refuse_overlap(scene, *suite);
  return scene;
}

}  // namespace animado
