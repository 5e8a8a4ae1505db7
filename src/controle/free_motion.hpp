// The motion of all bodies as if nothing touched: for each stage of the method the forces are evaluated,
// egesp solves for the accelerations, fred makes the next stage (design, section 5, step 2). The numbers stay
// in shared arrays; the messages name them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "controle/equations_of_motion.hpp"
#include "controle/forces.hpp"
#include "controle/kinematics.hpp"
#include "controle/meter.hpp"
#include "controle/workspace.hpp"
#include "egesp/client.hpp"
#include "fred/protocol.hpp"
#include "rpc/channel.hpp"

namespace animado::controle {

// Adds the forces of elastic contact at a stage (response spring).
class ContactForces {
 public:
  virtual ~ContactForces() = default;
  virtual double add(const Lanes& state, double* wrenches) = 0;  // returns their power, W
};

class FreeMotion {
 public:
  FreeMotion(rpc::Suite& suite, Workspace& workspace, Meter& meter, const std::string& method,
             const EquationsOfMotion& equations, const Forces& forces, const Kinematics& kinematics,
             ContactForces* contact_forces);

  Lanes make_state(const std::string& name);  // a shared array of shape (13, N)

  // Puts the kinematic bodies of a state where they are at time_s.
  void place_kinematic(const Lanes& state, double time_s) const {
    kinematics_.place(state.values, bodies_, time_s);
  }

  // Moves `from`, the state at time_s, by step_s into `to`. Throws Error diverged when the motion leaves the
  // finite.
  void step(const Lanes& from, double time_s, double step_s, const Lanes& to) {
    start(from, time_s);
    go(step_s, to);
  }

  // The same in two parts, for several tries from one start.
  void start(const Lanes& from, double time_s);
  void go(double step_s, const Lanes& to);
  // The same as start() where `from` holds the end of the last step, if the rates there are known; whether
  // they are.
  bool start_at_end(const Lanes& from, double time_s);

  // What an embedded method knows of the last step. Neither changes its end; both may evaluate forces.
  bool is_embedded() const { return tableau_.error_order > 0; }
  bool has_dense_output() const { return is_embedded() && tableau_.dense_order > 3; }  // better than a cubic
  // fred's estimate of its error, each body a system of its own. The request brings tolerances and memory.
  fred::Estimate::Reply estimate(fred::Estimate::Request request);
  // Its dense output at a part θ of it.
  void dense(double theta, const Lanes& out);

  // The energies of the last step, by the method's own quadrature over its stages: of each drive, and of
  // elastic contact.
  std::vector<Work> work() const;
  double contact_work_J() const;

  // Of the last step's start, (6, N): acceleration of the frame's origin (world) and angular (body axes).
  rpc::Array start_accelerations() const { return accelerations(0); }
  int order() const { return static_cast<int>(tableau_.order); }  // of convergence of the method

 private:
  rpc::Array accelerations(size_t stage) const;  // (6, N): rows v' and w' of a stage's rates
  size_t stages() const { return tableau_.nodes.size(); }
  void make_stage(size_t stage, double node, const Lanes& out);
  void rates(const Lanes& state, double time_s, size_t stage);
  Error divergence_at(const Lanes& state, double time_s) const;
  void end_rates();
  void normalize(double* state) const;

  size_t bodies_;
  egesp::SolvePrepared::Request solve_;
  fred::Stage::Request stage_;
  rpc::Channel& fred_;
  fred::Methods::Method tableau_;
  bool estimate_reads_end_ = false;
  Workspace& workspace_;
  Meter& meter_;
  const EquationsOfMotion& equations_;
  const Forces& forces_;
  const Kinematics& kinematics_;
  ContactForces* contact_forces_;
  egesp::PreparedSystems matrices_;  // of equation (1), a constant one for each body
  Lanes right_sides_, rates_, stage_state_;
  std::vector<double> wrenches_;
  std::vector<std::vector<Power>> powers_;  // of each stage of the last step
  std::vector<double> contact_powers_W_;
  double time_s_ = 0, step_s_ = 0;                // of the last step
  Lanes end_;                                     // likewise
  bool knows_end_ = false, knows_dense_ = false;  // the rates at its end, and those that only `dense` needs
};

}  // namespace animado::controle
