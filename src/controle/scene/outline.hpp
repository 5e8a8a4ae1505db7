// A scene file cut into blocks and properties: which words stand where. What the values mean comes later.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "controle/scene/scene.hpp"
#include "controle/scene/vocabulary.hpp"

namespace animado::controle {

struct Entry {
  const Property* property = nullptr;
  Place place;       // of the property's name
  Expression value;  // not empty
};

struct Section {
  std::string name, folded_name;  // of an object; of the block else
  Place place;                    // where it was opened first
  std::vector<Entry> entries;     // none twice, but those that add up

  const Entry* find(std::string_view canonical) const;
};

struct Outline {
  std::string path;
  std::vector<Section> objects;
  Section world{"world", "world", {}, {}}, time{"time", "time", {}, {}};
  std::vector<Definition> names;

  std::vector<std::string> object_names() const;
};

// Throws Error: syntax, unknown_name, conflict.
Outline read_outline(std::string_view text, const std::string& path);

}  // namespace animado::controle
