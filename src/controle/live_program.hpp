// An expression of the scene, evaluated over the state of the moment: at every stage of a step, never a round
// trip.
#pragma once

#include <vector>

#include "base/state.hpp"
#include "controle/scene/scope.hpp"
#include "interexpserv/program.hpp"

namespace animado::controle {

// The state that an expression sees.
struct Moment {
  const double* state;  // (13, bodies)
  size_t bodies;
  double time_s;
};

class LiveProgram {
 public:
  // Compiles a vector expression and binds its inputs (t, ball.position, ball.orientation.qw …) to the
  // columns of the state. Throws Error with file:line:column.
  LiveProgram(const SceneScope& scope, const Expression& expression);

  const interexpserv::Program& program() const { return program_; }
  const std::vector<Reading>& readings() const { return readings_; }  // of its inputs

  Vec3 vector(const Moment& moment) const;
  // The value and its rate of change, by dual numbers: positions change with velocities, orientations with
  // angular velocities; velocities count as constant.
  Vec3 vector_with_rate(const Moment& moment, Vec3& rate) const;

 private:
  void gather(const Moment& moment) const;
  void gather_rates(const Moment& moment) const;

  interexpserv::Program program_;
  std::vector<Reading> readings_;
  mutable std::vector<double> inputs_, rates_;  // of one evaluation
};

}  // namespace animado::controle
