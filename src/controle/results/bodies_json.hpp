// bodies.json: who moves in a run, so that a picture can be made of it without its scene.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/shape.hpp"

namespace animado::controle {

struct RecordedBody {
  std::string name = {};
  Motion motion = Motion::dynamic;
  double mass_kg = 0;                     // 0 of what is not dynamic and gives none
  Vec3 color_srgb = Vec3::Constant(0.7);  // each in 0 … 1, as CSS means them
  Shape shape = Sphere{1};
};

std::string bodies_text(const std::vector<RecordedBody>& bodies);
// Throws Error(bad_input) when the text is not what bodies_text makes; `where` names it.
std::vector<RecordedBody> parse_bodies(const std::string& text, const std::string& where);

}  // namespace animado::controle
