// A value that is written as a call: sphere(radius=0.5), hull("file.obj"), static.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controle/scene/scene.hpp"

namespace animado::controle {

struct Argument {
  std::string name;  // folded; empty when it is not said
  Place place;
  Expression value;
  std::optional<std::string> text;  // what stands between quotes
};

struct Call {
  std::string name;  // folded
  Place place;
  std::vector<Argument> arguments;
};

// Throws Error: syntax. `expected` says in messages what should have been there.
Call parse_call(const Expression& value, std::string_view path, std::string_view expected);

}  // namespace animado::controle
