// What an option takes, told from the name of its type, which --help shows too: SCENE, DIR, FILE, or the
// words between braces.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace animado {

enum class ValueKind { none, scenes, folders, files, words };

struct Values {
  ValueKind kind = ValueKind::none;
  std::vector<std::string> words = {};
};

Values values_of(const CLI::Option& option);

}  // namespace animado
