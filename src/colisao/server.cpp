#include "colisao/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/number_text.hpp"
#include "colisao/impulse.hpp"
#include "colisao/response_tolerances.hpp"
#include "colisao/server.records.hpp"
#include "colisao/springs.hpp"
#include "colisao/sweep.hpp"
#include "colisao/system15.hpp"
#include "egesp/client.hpp"
#include "rpc/destination.hpp"

namespace animado::colisao {
namespace {

// Sets of bodies that are kept: a run has one, a test bench a few. Who comes back to a forgotten one prepares
// it again.
constexpr size_t kPreparedSets = 8;

// Sub-steps of one request: beyond it a step has been mistaken for a run.
constexpr int64_t kMostSubsteps = 100'000;

class PreparedSets {
 public:
  Prepare::Reply add(const Prepare::Request& request) {
    const std::string handle = handle_of(request);
    if (!find(handle)) sets_.emplace_front(handle, prepared(request));
    if (sets_.size() > kPreparedSets) sets_.pop_back();
    return {handle};
  }

  std::shared_ptr<const Prepared> at(const std::string& handle) {
    if (auto set = find(handle)) return set;
    throw Error(Code::unknown_handle, fmt::format("no bodies are prepared as `{}`", handle), "handle",
                "send prepare with the same bodies, then repeat the request");
  }

 private:
  // Moves the one found to the front: the last one is the longest unused.
  std::shared_ptr<const Prepared> find(const std::string& handle) {
    const auto found = std::ranges::find(sets_, handle, [](const auto& set) { return set.first; });
    if (found == sets_.end()) return nullptr;
    sets_.splice(sets_.begin(), sets_, found);
    return sets_.front().second;
  }

  std::list<std::pair<std::string, std::shared_ptr<const Prepared>>> sets_;
};

// The numbers of a (rows, bodies) array; all finite.
std::span<const double> read(rpc::Call& call, const Array& array, int64_t rows, const Prepared& bodies,
                             const char* field) {
  const std::vector<int64_t> shape = {rows, static_cast<int64_t>(bodies.size())};
  if (array.shape != shape) {
    throw Error(
        Code::bad_shape,
        fmt::format("shape ({}) where ({}, {}) is needed", fmt::join(array.shape, ", "), shape[0], shape[1]),
        field, "one column for each body of prepare");
  }
  const std::span<const double> values = call.read(array);
  if (!all_finite(values)) {
    const auto bad = std::ranges::find_if_not(values, [](double x) { return std::isfinite(x); });
    if (bad == values.end()) return values;  // who shares the memory wrote meanwhile
    const auto at = bad - values.begin();
    throw Error(Code::not_finite,
                fmt::format("{} in row {}, body {}", number_text(*bad), at / shape[1], at % shape[1]), field,
                "the motion has diverged, or the array was not filled");
  }
  return values;
}

double positive(double value, const char* field) {
  if (value > 0 && std::isfinite(value)) return value;
  throw Error(Code::bad_params, fmt::format("{} where a positive number is needed", value), field);
}

double not_negative(double value, const char* field) {
  if (value >= 0 && std::isfinite(value)) return value;
  throw Error(Code::bad_params, fmt::format("{} where 0 or more is needed", value), field);
}

Contacts::Reply contacts(const Contacts::Request& request, const Prepared& bodies, rpc::Call& call) {
  const auto state = read(call, request.state, kStateRows, bodies, "state");
  const std::vector<Moving> moved = moving(bodies.bodies, bodies.states(state.data()));
  Contacts::Reply reply;
  for (const Contact& c : bodies.contacts(state.data(), not_negative(request.margin_m, "margin_m"))) {
    const Moving &a = moved[static_cast<size_t>(c.a)], &b = moved[static_cast<size_t>(c.b)];
    reply.contacts.push_back(record(c, relative_velocity(a, b, c.point_m)));
  }
  return reply;
}

Sweep::Reply sweep_bodies(const Sweep::Request& request, const Prepared& bodies, rpc::Call& call) {
  const auto from = read(call, request.from, kStateRows, bodies, "from");
  const auto to = read(call, request.to, kStateRows, bodies, "to");
  const SweepResult found =
      sweep(bodies.colliders, bodies.broad_phase, from.data(), to.data(), positive(request.step_s, "step_s"));
  return {found.hit, found.near, found.time_s, found.a, found.b, found.candidates};
}

PointResponse point_response(Response response, rpc::Suite& suite) {
  switch (response) {
    case Response::impulse:
      return closed_form();
    case Response::system15:
      return [&suite](const Moving& a, const Moving& b, const Contact& contact, double friction,
                      double rebound) {
        egesp::Client egesp(suite.channel("egesp"));
        const Solve15 solve = [&](const auto& matrix, const auto& right) {
          return egesp.solve(matrix, right);
        };
        return point_impulse_by_system15(a, b, contact, friction, rebound, solve).impulse_N_s;
      };
    case Response::spring:
      break;
  }
  throw Error(Code::bad_params, "springs answer by forces, not by impulses", "response",
              "ask for impulse or system15, or send springs");
}

Respond::Reply respond(const Respond::Request& request, const Prepared& bodies, rpc::Call& call,
                       rpc::Suite& suite) {
  const auto state = read(call, request.state, kStateRows, bodies, "state");
  rpc::Destination out(call, request.out, request.state.shape, {state});
  std::vector<BodyState> states = bodies.states(state.data());
  std::vector<Moving> moved = moving(bodies.bodies, states);
  std::vector<Meet> meets;
  for (const Contact& c : bodies.contacts(state.data(), kTouch_m))
    meets.push_back({c, bodies.bodies.surface(c.a, c.b), 0});
  const SimultaneousResult result = respond_together(moved, meets, bodies.bodies.contact_threshold_m_s,
                                                     point_response(request.response, suite));

  std::ranges::copy(state, out.values().begin());
  Respond::Reply reply;
  std::vector<bool> pushed(bodies.size(), false);
  for (const AnsweredImpact& impact : result.impacts) {
    const Contact& c = meets[static_cast<size_t>(impact.meet)].contact;
    pushed[static_cast<size_t>(c.a)] = pushed[static_cast<size_t>(c.b)] = true;
    reply.impacts.push_back(record(c.a, c.b, 0, c, impact));
  }
  for (size_t i = 0; i < bodies.size(); ++i) {
    if (!pushed[i] || !bodies.bodies[i].is_dynamic()) continue;
    set_velocities(bodies.bodies[i], moved[i], states[i]);
    store_body(out.values().data(), bodies.size(), i, states[i]);
  }
  reply.state = std::move(out).take();
  reply.dissipated_impact_J = result.dissipated_impact_J;
  reply.dissipated_friction_J = result.dissipated_friction_J;
  reply.kinematic_work_J = result.work_of_told_J;
  reply.rounds = result.rounds;
  return reply;
}

Advance::Reply advance_bodies(const Advance::Request& request, const Prepared& bodies, rpc::Call& call) {
  const auto state = read(call, request.state, kStateRows, bodies, "state");
  const auto accelerations = read(call, request.accelerations, 6, bodies, "accelerations");
  const auto free = read(call, request.free, kStateRows, bodies, "free");
  if (request.substeps < 1 || request.substeps > kMostSubsteps) {
    throw Error(Code::limit, fmt::format("{} sub-steps; 1 … {} are served", request.substeps, kMostSubsteps),
                "substeps", "divide the step");
  }
  rpc::Destination out(call, request.out, request.state.shape, {state, accelerations, free});
  const AdvanceResult result =
      advance(bodies.bodies, bodies.finder(),
              {state.data(), accelerations.data(), free.data(), positive(request.step_s, "step_s"),
               static_cast<int>(request.substeps), request.crowded});
  std::ranges::copy(result.state, out.values().begin());
  Advance::Reply reply;
  reply.state = std::move(out).take();
  reply.moved.assign(result.moved.begin(), result.moved.end());
  for (const TimedImpact& impact : result.account.impacts) {
    reply.impacts.push_back(record(impact.a, impact.b, impact.time_s, impact.contact, impact.answer));
  }
  reply.dissipated_impact_J = result.account.dissipated_impact_J;
  reply.dissipated_friction_J = result.account.dissipated_friction_J;
  reply.kinematic_work_J = result.account.work_of_told_J;
  reply.islands = result.islands;
  reply.contacts = result.account.contacts;
  reply.iterations = result.account.iterations;
  reply.residual_m_s = result.account.residual_m_s;
  return reply;
}

Springs::Reply springs(const Springs::Request& request, const Prepared& bodies, rpc::Call& call) {
  const auto state = read(call, request.state, kStateRows, bodies, "state");
  const std::vector<BodyState> states = bodies.states(state.data());
  const std::vector<Contact> overlaps = bodies.contacts(state.data(), 0);
  const SpringForces forces =
      spring_forces(bodies.bodies, states, overlaps, not_negative(request.stiffness_N_m, "stiffness_N_m"),
                    not_negative(request.damping_N_s_m, "damping_N_s_m"));
  rpc::Destination out(call, request.out, {6, static_cast<int64_t>(bodies.size())}, {state});
  std::ranges::copy(forces.wrenches, out.values().begin());
  const std::vector<Moving> moved = moving(bodies.bodies, states);
  Springs::Reply reply;
  reply.wrenches = std::move(out).take();
  reply.stored_J = forces.stored_J;
  for (const Contact& c : overlaps) {
    const Moving &a = moved[static_cast<size_t>(c.a)], &b = moved[static_cast<size_t>(c.b)];
    reply.contacts.push_back(record(c, relative_velocity(a, b, c.point_m)));
  }
  return reply;
}

}  // namespace

void fill_table(rpc::Service& service, rpc::Suite& suite) {
  auto sets = std::make_shared<PreparedSets>();
  service.on<Prepare>([sets](const Prepare::Request& request) { return sets->add(request); })
      .on<Contacts>([sets](const Contacts::Request& r, rpc::Call& call) {
        return contacts(r, *sets->at(r.handle), call);
      })
      .on<Sweep>([sets](const Sweep::Request& r, rpc::Call& call) {
        return sweep_bodies(r, *sets->at(r.handle), call);
      })
      .on<Respond>([sets, &suite](const Respond::Request& r, rpc::Call& call) {
        return respond(r, *sets->at(r.handle), call, suite);
      })
      .on<Advance>([sets](const Advance::Request& r, rpc::Call& call) {
        return advance_bodies(r, *sets->at(r.handle), call);
      })
      .on<Springs>([sets](const Springs::Request& r, rpc::Call& call) {
        return springs(r, *sets->at(r.handle), call);
      });
}

}  // namespace animado::colisao
