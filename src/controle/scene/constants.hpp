// What can be computed before the motion starts: numbers, vectors, shapes and masses, which may need each
// other.
#pragma once

#include "controle/scene/outline.hpp"
#include "controle/scene/state_names.hpp"
#include "interexpserv/program.hpp"

namespace animado::controle {

class Constants : public interexpserv::Scope {
 public:
  explicit Constants(const Outline& outline);  // keeps a reference

  // Throws Error with the expression's place: what the language refuses, what depends on t or state, what is
  // not finite.
  double number(const Expression& expression) const;
  Vec3 vector(const Expression& expression) const;

  // Computed once. mass_kg: of a body that gives a mass or a density.
  const Shape& shape(size_t body) const;
  double mass_kg(size_t body) const;

  void check_definitions() const;  // that all of them compile, used or not; of cycles among them

  // For the compiler: masses are values, the rest of the state and t inputs, definitions values where they
  // are constant.
  std::optional<interexpserv::Symbol> find(std::string_view folded_name) const override;
  std::vector<std::string> known_names() const override;
  std::string path_of(std::string_view written) const override;

 private:
  interexpserv::Program compile(const Expression& expression,
                                std::optional<interexpserv::Type> expected) const;
  interexpserv::Value evaluate(const Expression& expression, interexpserv::Type type) const;
  double compute_mass(size_t body) const;
  interexpserv::Symbol compute_definition(const Definition& definition) const;

  // A name for as long as it is being computed.
  class Open;

  const Outline& outline_;
  StateNames names_;
  mutable std::map<size_t, double> masses_;
  mutable std::map<size_t, Shape> shapes_;
  mutable std::map<std::string, interexpserv::Symbol, std::less<>> definitions_;
  mutable std::vector<std::string> open_;    // outermost first
  mutable std::vector<Expression> reading_;  // the expression that each level reads
};

}  // namespace animado::controle
