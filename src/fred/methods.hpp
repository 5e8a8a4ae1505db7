// All methods by name, whatever kind they are, and each of them set to work on a problem.
#pragma once

#include <memory>
#include <optional>

#include "fred/stepper.hpp"
#include "fred/tableau.hpp"
#include "fred/vocabulary.hpp"

namespace animado::fred {

struct Method {
  std::string name, reference;
  MethodKind kind;
  int order = 0, stages = 0, error_order = 0, dense_order = 0;
  const Tableau* tableau = nullptr;  // of the explicit ones

  bool is_adaptive() const { return kind == MethodKind::explicit_adaptive || kind == MethodKind::implicit; }
};

// The default first.
const std::vector<Method>& methods();

// Throws unknown_name, with the nearest name.
const Method& method_named(std::string_view name);

// What is integrated. The functions are kept and called later; the last two are asked for where a method
// needs them.
struct Problem {
  Derivative derivative;
  double t0 = 0;
  std::vector<double> y = {};
  Jacobian jacobian = {};
  std::function<std::vector<bool>()> positions =
      {};  // of a separable problem (Symplectic); throws where it is not
};

struct Adaptive {
  Tolerance tolerance;
  double largest = 0;  // step, 0 for any
};

// Equal steps: EqualTimes. Requires that the method can do what is asked of it.
std::unique_ptr<Stepper> equal_stepper(const Method& method, const Problem& problem, double step);
std::unique_ptr<Stepper> adaptive_stepper(const Method& method, const Problem& problem,
                                          const Adaptive& steps);

// Goes on where a checkpoint was made, with the same method and, where it is adaptive, the same tolerance.
// The problem's t0 and y are not looked at.
std::unique_ptr<Stepper> resumed_stepper(const Method& method, const Problem& problem, const Checkpoint& from,
                                         const std::optional<Adaptive>& steps);

}  // namespace animado::fred
