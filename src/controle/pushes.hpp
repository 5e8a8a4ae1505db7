// What the scene's expressions push: forces and torques, in world or in body axes. Expressions of one formula
// are evaluated as one batch, and added row by row.
#pragma once

#include <vector>

#include "controle/program_batch.hpp"

namespace animado::controle {

// One body's forces and torques other than gravity. Repeated lines add up.
struct Drive {
  size_t body = 0;
  std::vector<LiveProgram> forces, torques, local_forces, local_torques;
  double linear_damping_1_s = 0, angular_damping_1_s = 0;

  bool is_damped() const { return linear_damping_1_s != 0 || angular_damping_1_s != 0; }
};

class Pushes {
 public:
  // The drives' programs are used later.
  explicit Pushes(const std::vector<Drive>& drives);

  // out: wrenches (6, N), world axes; −0 of a body without a push: nothing changes what it is added to. A
  // body's forces are added in the order of its lines, those in body axes last; its torques likewise.
  void evaluate(const Moment& moment, double* out);

 private:
  // Pushes that are added in the same turn, one of a body.
  struct Group {
    ProgramBatch batch;
    bool torque, local;
    size_t turn;
    std::vector<size_t> bodies;  // of each lane
  };
  void take(const LiveProgram& program, size_t body, bool torque, bool local, size_t turn);

  std::vector<Group> groups_;
};

}  // namespace animado::controle
