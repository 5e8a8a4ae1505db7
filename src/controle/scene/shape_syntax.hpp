// shape sphere(radius=0.5): from text to solid.
#pragma once

#include <span>

#include "controle/scene/constants.hpp"
#include "controle/scene/vocabulary.hpp"

namespace animado::controle {

struct ShapeParameter {
  std::string_view canonical, synonym;
  enum class Kind { length, lengths, vector, number, file } kind;
  bool needed = true;
};
struct ShapeForm {
  Word word;
  std::vector<ShapeParameter> parameters;
  std::string_view example, meaning;  // for messages and docs/scene-format.md
};
std::span<const ShapeForm> shape_forms();

// The shape of an object: as given, or by its name. Throws Error with its place.
Shape read_shape(const Outline& outline, size_t object, const Constants& constants);

}  // namespace animado::controle
