// What the names in an expression mean, as told by whoever compiles it: a scene, a system of equations, the
// registry.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interexpserv/builder.hpp"

namespace animado::interexpserv {

// A name that stands for another expression, compiled where it is used; or, where the text is
// "(x, y) = expression", for a function.
struct Definition {
  std::string name;  // folded, full: what a cycle lists
  std::string text;
  std::string home;  // the namespace whose prefix its text may leave out; may be empty
};

using Symbol = std::variant<Value, Input, Definition>;

class Scope {
 public:
  virtual ~Scope() = default;

  // `name` is folded and dotted as written: "ball.position", "mass". A component of a vector
  // ("ball.position.y") is found by the compiler when the whole name is unknown here.
  virtual std::optional<Symbol> find(std::string_view name) const = 0;
  virtual std::vector<std::string> known_names() const = 0;  // for suggestions

  // The file that a table's name means; by itself, relative to where the program runs.
  virtual std::string path_of(std::string_view written) const { return std::string(written); }

  // The scope without any default namespace: where the text of a definition is read.
  virtual const Scope& root() const { return *this; }
};

// Names in a map.
class MapScope : public Scope {
 public:
  MapScope& set(std::string_view name, Value value);
  MapScope& input(std::string_view name, Type type);
  MapScope& define(std::string_view name, std::string text, std::string_view home = {});

  std::optional<Symbol> find(std::string_view name) const override;
  std::vector<std::string> known_names() const override;

 private:
  std::map<std::string, Symbol, std::less<>> symbols_;
};

// Another scope, seen from inside an object's block: `mass` is ball.mass if there is one.
class HomeScope : public Scope {
 public:
  HomeScope(const Scope& outer, std::string_view home);

  std::optional<Symbol> find(std::string_view name) const override;
  std::vector<std::string> known_names() const override;
  std::string path_of(std::string_view written) const override { return outer_.path_of(written); }
  const Scope& root() const override { return outer_.root(); }

 private:
  const Scope& outer_;
  std::string prefix_;  // "ball."
};

}  // namespace animado::interexpserv
