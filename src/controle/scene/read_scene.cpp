// Text → outline → constants → bodies → checks among them.
#include "controle/scene/check_dimensions.hpp"
#include "controle/scene/check_expressions.hpp"
#include "controle/scene/constants.hpp"
#include "controle/scene/read_body.hpp"
#include "controle/scene/read_world.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/scope.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

void refuse_empty(const Outline& outline, std::string_view text) {
  if (!outline.objects.empty()) return;
  const bool empty = text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  refuse(outline.path, {1, 1}, Code::refused, empty ? "the scene is empty" : "the scene has no object",
         "a scene begins with `object NAME` and its properties; scenes/ has examples");
}

void check_groups(const Scene& scene) {
  std::vector<std::string> known;
  for (const Body& body : scene.bodies) {
    if (!body.group.empty()) known.push_back(body.group);
  }
  for (const Body& body : scene.bodies) {
    for (const std::string& group : body.collides_with) {
      if (std::find(known.begin(), known.end(), group) != known.end()) continue;
      refuse(scene.path, body.places.at("collides with"), Code::unknown_name,
             fmt::format("no object is of the group `{}`", group),
             suggestion(group, known, "give an object `group " + group + "`"));
    }
  }
}

// From here on a definition means the same wherever it is read: the registry knows no blocks.
void qualify_names(Scene& scene) {
  const SceneScope scope(scene);
  for (Definition& name : scene.names) {
    name.value.text = scope.qualified(name.value);
    name.value.owner = -1;
  }
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& path) {
  const Outline outline = read_outline(text, path);
  refuse_empty(outline, text);
  const Constants constants(outline);
  constants.check_definitions();
  Scene scene;
  scene.path = path;
  scene.text = text;
  scene.names = outline.names;
  for (size_t i = 0; i < outline.objects.size(); ++i)
    scene.bodies.push_back(read_body(outline, i, constants));
  scene.world = read_world(outline, constants);
  scene.time = read_time(outline, constants);
  check_groups(scene);
  check_expressions(scene);
  check_dimensions(outline, scene);
  qualify_names(scene);
  return scene;
}

Scene read_scene(const std::string& path) {
  return parse_scene(read_text(path), path);
}

}  // namespace animado::controle
