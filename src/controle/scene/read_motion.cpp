#include <array>
#include <filesystem>

#include "controle/scene/call.hpp"
#include "controle/scene/read_body.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/script_file.hpp"

namespace animado::controle {
namespace {

const std::array<Word, 4>& motions() {
  static const std::array<Word, 4> words = {
      {{"dynamic", {"dinamico", "dinamica"}},
       {"static", {"estatico", "estatica", "fixed", "fixo", "fixa"}},
       {"path", {"trajetoria", "kinematic", "cinematico", "cinematica"}},
       {"script", {"roteiro"}}}};
  return words;
}

std::vector<ScriptRow> rows_of(const Outline& outline, const Call& call) {
  if (call.arguments.size() != 1 || !call.arguments[0].text) {
    refuse(outline.path, call.place, Code::syntax, "a script needs its file", "write script(\"file.csv\")");
  }
  const auto path = std::filesystem::path(outline.path).parent_path() / *call.arguments[0].text;
  try {
    return read_script(path.string());
  } catch (const Error& error) {
    refuse(outline.path, call.arguments[0].place, error.code(),
           fmt::format("{}: {}", error.where(), error.message()), error.remedy());
  }
}

void read_path(const Outline& outline, const Section& object, Place motion, Body& body) {
  if (const Entry* entry = object.find("path position")) body.path_position = entry->value;
  if (const Entry* entry = object.find("path rotation")) body.path_rotation = entry->value;
  if (!body.path_position && !body.path_rotation) {
    refuse(outline.path, motion, Code::refused,
           fmt::format("`{}` has `motion path` and no path", object.name),
           "give `path position`, `path rotation` or both, as expressions of t");
  }
}

}  // namespace

void read_motion(const Outline& outline, const Section& object, Body& body) {
  const Entry* entry = object.find("motion");
  std::string_view motion = "dynamic";
  Place place = entry ? entry->place : object.place;
  if (entry) {
    const Call call = parse_call(entry->value, outline.path, "dynamic, static, path or script(\"file.csv\")");
    motion = canonical_word(motions(), call.name);
    if (motion.empty()) {
      const std::vector<std::string> known = all_forms(motions());
      refuse(outline.path, call.place, Code::unknown_name, fmt::format("unknown motion `{}`", call.name),
             suggestion(call.name, known, "a motion is dynamic, static, path or script(\"file.csv\")"));
    }
    if (motion == "script") body.script = rows_of(outline, call);
    if (motion != "script" && !call.arguments.empty()) {
      refuse(outline.path, call.arguments[0].place, Code::syntax,
             fmt::format("`{}` takes nothing in parentheses", motion),
             motion == "path" ? "write the expressions on lines `path position` and `path rotation`"
                              : "leave them out");
    }
  }
  body.motion = motion == "dynamic"  ? Motion::dynamic
                : motion == "static" ? Motion::fixed
                                     : Motion::kinematic;
  if (motion == "path") read_path(outline, object, place, body);
  for (const std::string_view name : {"path position", "path rotation"}) {
    const Entry* path = object.find(name);
    if (path && motion != "path") {
      refuse(outline.path, path->place, Code::conflict,
             fmt::format("`{}` has a {} and `motion {}`", object.name, name, motion), "write `motion path`");
    }
  }
  if (std::holds_alternative<HalfSpace>(body.shape) && body.motion != Motion::fixed) {
    refuse(outline.path, place, Code::refused,
           fmt::format("`{}` is a plane without end, and {}", object.name, motion), "write `motion static`");
  }
}

}  // namespace animado::controle
