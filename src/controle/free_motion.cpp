#include "controle/free_motion.hpp"

#include "base/error.hpp"
#include "base/state.hpp"

namespace animado::controle {
namespace {

fred::Methods::Method method_named(rpc::Channel& fred, const std::string& name) {
  std::string known;
  for (fred::Methods::Method& method : fred.call<fred::Methods>({}).methods) {
    if (method.name == name) return method;
    known += (known.empty() ? "" : ", ") + method.name;
  }
  throw Error(Code::unknown_name, "fred has no method `" + name + "`", "world: method",
              "It has: " + known + ".");
}

egesp::Prepare::Request matrices_of(const EquationsOfMotion& equations, Workspace& workspace) {
  const Lanes matrices = workspace.make("matrices", {6, 6, static_cast<int64_t>(equations.bodies())});
  equations.matrices(matrices.values);
  egesp::Prepare::Request request;
  request.matrices = matrices.array;
  request.layout = egesp::Layout::lanes;
  return request;
}

}  // namespace

FreeMotion::FreeMotion(rpc::Suite& suite, Workspace& workspace, Meter& meter, const std::string& method,
                       const EquationsOfMotion& equations, const Forces& forces, const Kinematics& kinematics,
                       ContactForces* contact_forces)
    : bodies_(equations.bodies()),
      fred_(suite.channel("fred")),
      workspace_(workspace),
      meter_(meter),
      equations_(equations),
      forces_(forces),
      kinematics_(kinematics),
      contact_forces_(contact_forces),
      matrices_(suite.channel("egesp"), matrices_of(equations, workspace)),
      wrenches_(6 * bodies_) {
  const auto n = static_cast<int64_t>(bodies_);
  const auto tableau = method_named(fred_, method);
  nodes_ = tableau.nodes;
  weights_ = tableau.weights;
  powers_.resize(nodes_.size());
  contact_powers_W_.resize(nodes_.size());
  order_ = static_cast<int>(tableau.order);

  right_sides_ = workspace.make("right_sides", {6, n});
  rates_ = workspace.make("rates", {tableau.stages, kStateRows, n});
  stage_state_ = make_state("stage");

  solve_.right_sides = right_sides_.array;
  solve_.layout = egesp::Layout::lanes;
  stage_.method = method;
  stage_.derivatives = rates_.array;
}

Lanes FreeMotion::make_state(const std::string& name) {
  return workspace_.make(name, {kStateRows, static_cast<int64_t>(bodies_)});
}

rpc::Array FreeMotion::accelerations(size_t stage) const {
  const auto n = static_cast<int64_t>(bodies_);
  return rpc::Array::named(rates_.array.shared, {6, n}, static_cast<int64_t>(stage * kStateRows + kVx) * n);
}

void FreeMotion::rates(const Lanes& state, double time_s, size_t stage) {
  powers_[stage].resize(forces_.driven());
  forces_.evaluate({state.values, bodies_, time_s}, wrenches_.data(), powers_[stage].data());
  if (contact_forces_) contact_powers_W_[stage] = contact_forces_->add(state, wrenches_.data());
  equations_.right_sides(state.values, wrenches_.data(), right_sides_.values);
  solve_.out = accelerations(stage);  // in body axes as yet
  meter_.timed("egesp", "solve_prepared", [&] { return matrices_.solve(solve_); });
  equations_.complete_rates(state.values, rates_.values + stage * kStateRows * bodies_);
}

void FreeMotion::step(const Lanes& from, double time_s, double step_s, const Lanes& to) {
  stage_.state = from.array;
  stage_.step = step_s;
  step_s_ = step_s;
  const size_t stages = nodes_.size();
  for (size_t s = 0; s < stages; ++s) {
    rates(s == 0 ? from : stage_state_, time_s + nodes_[s] * step_s, s);
    const bool last = s + 1 == stages;
    const Lanes& next = last ? to : stage_state_;
    stage_.stage = static_cast<int64_t>(s + 1);
    stage_.out = next.array;
    meter_.timed("fred", "stage", [&] { return fred_.call<fred::Stage>(stage_); });
    kinematics_.place(next.values, bodies_, time_s + (last ? step_s : nodes_[s + 1] * step_s));
  }
  normalize(to.values);
}

std::vector<Work> FreeMotion::work() const {
  std::vector<Work> sum(forces_.driven());
  for (size_t s = 0; s < nodes_.size(); ++s) {
    for (size_t d = 0; d < sum.size(); ++d) {
      sum[d].done_J += step_s_ * weights_[s] * powers_[s][d].work_W;
      sum[d].damped_J += step_s_ * weights_[s] * powers_[s][d].damping_W;
    }
  }
  return sum;
}

double FreeMotion::contact_work_J() const {
  double sum = 0;
  for (size_t s = 0; s < nodes_.size(); ++s) sum += step_s_ * weights_[s] * contact_powers_W_[s];
  return sum;
}

// The method keeps a quaternion's length only to its order.
void FreeMotion::normalize(double* state) const {
  const size_t n = bodies_;
  double* const q = state + kQw * n;
#pragma GCC ivdep
  for (size_t i = 0; i < n; ++i) {
    const double w = q[i], x = q[n + i], y = q[2 * n + i], z = q[3 * n + i];
    const double scale = 1 / std::sqrt(w * w + x * x + y * y + z * z);
    q[i] = w * scale;
    q[n + i] = x * scale;
    q[2 * n + i] = y * scale;
    q[3 * n + i] = z * scale;
  }
}

}  // namespace animado::controle
