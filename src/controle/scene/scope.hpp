// What the names of a scene mean to the compiler of expressions: t, the objects' state, the scene's
// definitions.
#pragma once

#include "controle/scene/scene.hpp"
#include "controle/scene/state_names.hpp"
#include "interexpserv/program.hpp"

namespace animado::controle {

// Keeps a reference: a scene that changes (live edits of forces or names) is seen by the next compile.
class SceneScope : public interexpserv::Scope {
 public:
  explicit SceneScope(const Scene& scene);

  // mass is a value; position, orientation.q*, velocity, angular_velocity (world) and t are inputs; force and
  // the scene's own names are definitions.
  std::optional<interexpserv::Symbol> find(std::string_view folded_name) const override;
  std::vector<std::string> known_names() const override;
  std::string path_of(std::string_view written) const override;  // beside the scene

  // Throws Error with file:line:column of the mistake.
  interexpserv::Program compile(const Expression& expression,
                                std::optional<interexpserv::Type> expected = {}) const;

  // The text with every prefix that its block lets it leave out: it means the same anywhere.
  std::string qualified(const Expression& expression) const;

  const StateNames& state_names() const { return names_; }

 private:
  interexpserv::Definition force_of(const Body& body) const;
  interexpserv::Definition local_force_of(const Body& body) const;

  const Scene& scene_;
  StateNames names_;
};

// "a", "(a) + (b)", or the zero vector: the text of a property whose lines add up.
std::string vector_sum(const std::vector<Expression>& expressions);

// Compiles an expression that stands in a file. home: the object whose prefix may be left out; may be empty.
// Throws Error with file:line:column of the mistake.
interexpserv::Program compile_at(std::string_view path, const Expression& expression,
                                 const interexpserv::Scope& scope, std::string_view home,
                                 std::optional<interexpserv::Type> expected);

}  // namespace animado::controle
