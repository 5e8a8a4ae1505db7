#include "controle/free_motion.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>

#include "base/error.hpp"
#include "base/state.hpp"
#include "controle/divergence.hpp"

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

// Whether the estimate weighs the rates at the end of the step (the last of each row of errors).
bool reads_end(const fred::Methods::Method& method) {
  return !method.errors.values.empty() && method.errors.values[static_cast<size_t>(method.stages)] != 0;
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
      tableau_(method_named(fred_, method)),
      workspace_(workspace),
      meter_(meter),
      equations_(equations),
      forces_(forces),
      kinematics_(kinematics),
      contact_forces_(contact_forces),
      matrices_(suite.channel("egesp"), matrices_of(equations, workspace)),
      wrenches_(6 * bodies_) {
  const auto n = static_cast<int64_t>(bodies_);
  const auto derivatives = static_cast<size_t>(tableau_.derivatives);
  powers_.resize(derivatives);
  contact_powers_W_.resize(derivatives);

  right_sides_ = workspace.make("right_sides", {6, n});
  rates_ = workspace.make("rates", {tableau_.derivatives, kStateRows, n});
  stage_state_ = make_state("stage");

  solve_.right_sides = right_sides_.array;
  solve_.layout = egesp::Layout::lanes;
  stage_.method = method;
  estimate_reads_end_ = reads_end(tableau_);
  stage_.derivatives = rates_.array;
}

Lanes FreeMotion::make_state(const std::string& name) {
  return workspace_.make(name, {kStateRows, static_cast<int64_t>(bodies_)});
}

rpc::Array FreeMotion::accelerations(size_t stage) const {
  const auto n = static_cast<int64_t>(bodies_);
  return rpc::Array::named(rates_.array.shared, {6, n}, static_cast<int64_t>(stage * kStateRows + kVx) * n);
}

void FreeMotion::rates(const Lanes& state, double time_s, size_t stage) try {
  powers_[stage].resize(forces_.driven());
  forces_.evaluate({state.values, bodies_, time_s}, wrenches_.data(), powers_[stage].data());
  if (contact_forces_) contact_powers_W_[stage] = contact_forces_->add(state, wrenches_.data());
  equations_.right_sides(state.values, wrenches_.data(), right_sides_.values);
  solve_.out = accelerations(stage);  // in body axes as yet
  meter_.timed("egesp", "solve_prepared", [&] { return matrices_.solve(solve_); });
  double* const rates = rates_.values + stage * kStateRows * bodies_;
  equations_.complete_rates(state.values, rates);
  kinematics_.hold(rates, bodies_);
} catch (const Error& error) {
  if (error.code() != Code::not_finite) throw;
  throw divergence_at(state, time_s);
}

// Of the body whose state is not finite, or else of the one with the largest right-hand side: its
// accelerations overflowed.
Error FreeMotion::divergence_at(const Lanes& state, double time_s) const {
  const auto is_finite = [](double v) { return std::isfinite(v); };
  const std::span<const double> values(state.values, kStateRows * bodies_);
  const auto size = [&](size_t e) {
    return is_finite(right_sides_.values[e]) ? std::abs(right_sides_.values[e]) : INFINITY;
  };
  auto at = static_cast<size_t>(std::ranges::find_if_not(values, is_finite) - values.begin());
  if (at == values.size()) at = *std::ranges::max_element(std::views::iota(size_t{0}, 6 * bodies_), {}, size);
  return divergence(forces_.scene(), at % bodies_, time_s);
}

// Writes to `out` where the derivative of this number is evaluated.
void FreeMotion::make_stage(size_t stage, double node, const Lanes& out) {
  stage_.stage = static_cast<int64_t>(stage);
  stage_.out = out.array;
  meter_.timed("fred", "stage", [&] { return fred_.call<fred::Stage>(stage_); });
  kinematics_.place(out.values, bodies_, time_s_ + node * step_s_);
}

void FreeMotion::start(const Lanes& from, double time_s) {
  stage_.state = from.array;
  time_s_ = time_s;
  rates(from, time_s, 0);
}

void FreeMotion::go(double step_s, const Lanes& to) {
  stage_.step = step_s_ = step_s;
  end_ = to;
  knows_end_ = knows_dense_ = false;
  for (size_t s = 1; s < stages(); ++s) {
    make_stage(s, tableau_.nodes[s], stage_state_);
    rates(stage_state_, time_s_ + tableau_.nodes[s] * step_s, s);
  }
  make_stage(stages(), 1, to);
  normalize(to.values);
}

void FreeMotion::end_rates() {
  if (!knows_end_) rates(end_, time_s_ + step_s_, stages());
  knows_end_ = true;
}

bool FreeMotion::start_at_end(const Lanes& from, double time_s) {
  if (!knows_end_) return false;
  const size_t size = kStateRows * bodies_;
  std::copy_n(rates_.values + stages() * size, size, rates_.values);
  powers_[0] = powers_[stages()];
  contact_powers_W_[0] = contact_powers_W_[stages()];
  stage_.state = from.array;
  time_s_ = time_s;
  return true;
}

fred::Estimate::Reply FreeMotion::estimate(fred::Estimate::Request request) {
  if (estimate_reads_end_) end_rates();
  request.method = stage_.method;
  request.step = step_s_;
  request.state = stage_.state;
  request.end = end_.array;
  request.derivatives = rates_.array;
  request.columns = true;
  return meter_.timed("fred", "estimate", [&] { return fred_.call<fred::Estimate>(request); });
}

void FreeMotion::dense(double theta, const Lanes& out) {
  end_rates();
  for (size_t extra = 0; extra < tableau_.extra_nodes.size() && !knows_dense_; ++extra) {
    const double node = tableau_.extra_nodes[extra];
    make_stage(stages() + 1 + extra, node, stage_state_);
    rates(stage_state_, time_s_ + node * step_s_, stages() + 1 + extra);
  }
  knows_dense_ = true;
  fred::Dense::Request request;
  request.method = stage_.method;
  request.step = step_s_;
  request.theta = theta;
  request.state = stage_.state;
  request.end = end_.array;
  request.derivatives = rates_.array;
  request.out = out.array;
  meter_.timed("fred", "dense", [&] { return fred_.call<fred::Dense>(request); });
  kinematics_.place(out.values, bodies_, time_s_ + theta * step_s_);
  normalize(out.values);
}

std::vector<Work> FreeMotion::work() const {
  std::vector<Work> sum(forces_.driven());
  for (size_t s = 0; s < stages(); ++s) {
    for (size_t d = 0; d < sum.size(); ++d) {
      sum[d].done_J += step_s_ * tableau_.weights[s] * powers_[s][d].work_W;
      sum[d].damped_J += step_s_ * tableau_.weights[s] * powers_[s][d].damping_W;
    }
  }
  return sum;
}

double FreeMotion::contact_work_J() const {
  double sum = 0;
  for (size_t s = 0; s < stages(); ++s) sum += step_s_ * tableau_.weights[s] * contact_powers_W_[s];
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
