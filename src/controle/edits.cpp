#include "controle/edits.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "controle/preparation.hpp"
#include "controle/scene/scope.hpp"
#include "interexpserv/parser.hpp"

namespace animado::controle {
namespace {

std::string text_of(const SceneScope& scope, const std::string& name) {
  const auto symbol = scope.find(name);
  assert(symbol);
  return std::get<interexpserv::Definition>(*symbol).text;
}

// The text with the files of its tables named in full: the registry runs in a folder of its own.
std::string with_whole_paths(const SceneScope& scope, const std::string& text) {
  const interexpserv::Expression parsed = interexpserv::parse({text, {}});
  std::string whole;
  size_t from = 0;
  for (const interexpserv::Token& token : parsed.tokens.list) {
    if (token.kind != interexpserv::Token::Kind::text) continue;
    const auto at = static_cast<size_t>(token.text.data() - text.data());
    whole += text.substr(from, at - from) + std::filesystem::absolute(scope.path_of(token.text)).string();
    from = at + token.text.size();
  }
  return whole + text.substr(from);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> definitions_of(const Scene& scene) {
  const SceneScope scope(scene);
  std::vector<std::pair<std::string, std::string>> definitions;
  for (const Body& body : scene.bodies) {
    if (body.motion != Motion::dynamic) continue;
    definitions.emplace_back(body.folded_name + ".mass", fmt::format("{:.17g}", body.mass_kg));
    if (!body.local_forces.empty()) {
      const std::string local = body.folded_name + ".local_force";
      definitions.emplace_back(local, text_of(scope, local));
    }
    const std::string force = body.folded_name + ".force";
    definitions.emplace_back(force, text_of(scope, force));
    definitions.emplace_back(body.folded_name + ".torque", vector_sum(body.torques));
  }
  for (const Definition& name : scene.names) definitions.emplace_back(name.name, name.value.text);
  for (auto& [name, text] : definitions) text = with_whole_paths(scope, text);
  return definitions;
}

Scene edited(const Scene& scene, const std::string& name, const std::string& text) {
  Scene changed = scene;
  const size_t dot = name.find('.');
  const int body = dot == std::string::npos ? -1 : scene.body_named(name.substr(0, dot));
  const Expression expression{text, {}, body};
  const std::string member = body < 0 ? "" : name.substr(dot + 1);
  if (member == "force") {
    changed.bodies[static_cast<size_t>(body)].forces = {expression};
    changed.bodies[static_cast<size_t>(body)].local_forces.clear();  // the name stands for their sum
    return changed;
  }
  if (member == "torque") {
    changed.bodies[static_cast<size_t>(body)].torques = {expression};
    return changed;
  }
  if (!may_be_edited(name)) {
    throw Error(Code::refused, "`" + name + "` cannot change while the run goes", name,
                "Edit the force or the torque.");
  }
  const auto same = [&](const Definition& definition) { return definition.name == name; };
  const auto found = std::find_if(changed.names.begin(), changed.names.end(), same);
  if (found == changed.names.end()) {
    changed.names.push_back({name, expression});
  } else {
    found->value = expression;
  }
  return changed;
}

bool may_be_edited(const std::string& name) {
  return !name.ends_with(".mass") && !name.ends_with(".local_force");
}

Scene checked_edit(const Scene& scene, const std::string& name, const std::string& text) {
  Scene changed = edited(scene, name, text);
  const SceneScope scope(changed);
  drives(changed, scope);
  paths(changed, scope);
  const bool is_own_name =
      std::ranges::any_of(changed.names, [&](const Definition& d) { return d.name == name; });
  if (is_own_name) scope.compile({text, {}, -1});  // nobody may use it yet
  return changed;
}

}  // namespace animado::controle
