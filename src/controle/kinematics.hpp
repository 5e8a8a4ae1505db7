// Bodies that move as they are told: along a path of expressions, or by the rows of a description file (the
// paper, section 4: "o estado pode ser lido ali").
#pragma once

#include <optional>
#include <vector>

#include "base/state.hpp"
#include "controle/live_program.hpp"

namespace animado::controle {

struct Path {
  size_t body = 0;
  std::optional<LiveProgram> position, rotation;  // what is missing stays as at the start
  RotationOrder rotation_order = {0, 1, 2};
  std::vector<ScriptRow> script;  // by time; used when neither expression is there
  BodyState start;
};

class Kinematics {
 public:
  explicit Kinematics(std::vector<Path> paths) : paths_(std::move(paths)) {}

  void replace(std::vector<Path> paths) { paths_ = std::move(paths); }  // after a live edit

  // Puts the pose and velocity of every kinematic body at the given time into the state.
  void place(double* state, size_t bodies, double time_s) const;

  // No rates for what is placed: no integration error either.
  void hold(double* rates, size_t bodies) const;

 private:
  std::vector<Path> paths_;
};

}  // namespace animado::controle
