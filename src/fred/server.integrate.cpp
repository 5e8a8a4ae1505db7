// Systems of expressions.
#include <algorithm>
#include <chrono>

#include "fred/equal_steps.hpp"
#include "fred/equations.hpp"
#include "fred/integrate.hpp"
#include "fred/methods.hpp"
#include "fred/protocol.hpp"
#include "fred/separable.hpp"
#include "fred/server.messages.hpp"
#include "interexpserv/client.hpp"

namespace animado::fred {
namespace {

using Clock = std::chrono::steady_clock;
using Request = Integrate::Request;

constexpr double kLargestEffort =
    1e9;  // evaluated right-hand sides in one request: about a minute, while other callers wait
constexpr int64_t kLargestReply = 1 << 22;  // numbers in samples and events: 32 MiB

NamedValues named_values(const std::vector<Integrate::Value>& values, const char* where) {
  NamedValues named;
  for (const auto& [name, value] : values) {
    refuse_infinite(value, fmt::format("{}[{}]", where, named.size()));
    named.emplace_back(name, value);
  }
  return named;
}

// The names that interexpserv holds now.
Lookup registry_of(rpc::Suite& suite) {
  return [&suite](std::string_view name) -> std::optional<interexpserv::Value> {
    try {
      const auto state = interexpserv::Client(suite).get(std::string(name));
      if (state.values.size() != width_of(state.type)) return {};
      interexpserv::Value value{state.type, {}};
      std::ranges::copy(state.values, value.v.begin());
      return value;
    } catch (const Error& error) {
      // Without a registry, or a name there, it is unknown: whoever compiles says so.
      if (error.code() == Code::unknown_name || error.code() == Code::unavailable) return {};
      throw;
    }
  };
}

const Method& chosen_method(const Request& request, bool adaptive) {
  const Method& method = method_named(!request.method.empty() ? request.method : adaptive ? "dopri5" : "rk4");
  if (adaptive && !method.is_adaptive()) {
    throw Error(
        Code::bad_params, fmt::format("{} does not know its error", method.name), "method",
        "use bs23, fehlberg45, cash_karp, dopri5, dop853, verner87 or radau5, or leave the tolerance out");
  }
  return method;
}

bool wants_tolerance(const Request& r) {
  return r.tolerance != 0 || !r.absolute_tolerance.empty() || !r.relative_tolerance.empty();
}

Tolerance tolerance_of(const Request& r, size_t size) {
  const double both = r.tolerance != 0 ? r.tolerance : 1e-6;
  const auto given = [&](const std::vector<double>& values) {
    return values.empty() ? std::vector{both} : values;
  };
  return checked_tolerance(given(r.absolute_tolerance), given(r.relative_tolerance), size);
}

void check_interval(const Request& request) {
  refuse_infinite(request.t0, "t0");
  refuse_infinite(request.t1, "t1");
  refuse_infinite(request.t1 - request.t0, "t1");
  refuse_infinite(request.step, "step");
  if (request.step < 0) {
    throw Error(Code::bad_params, fmt::format("the largest step is {}", request.step), "step",
                "give a length: the direction follows from t0 and t1");
  }
}

void check_samples(const Request& request, double t0) {
  const int64_t most = kLargestReply / (1 + static_cast<int64_t>(request.equations.size()));
  if (request.samples < 0 || request.samples > most || static_cast<int64_t>(request.times.size()) > most) {
    throw Error(Code::limit,
                fmt::format("{} samples", std::max<int64_t>(request.samples, request.times.size())),
                "samples", fmt::format("ask for 0 to {} samples", most));
  }
  const double direction = request.t1 < t0 ? -1 : 1;
  double last = t0;
  for (size_t i = 0; i < request.times.size(); ++i) {
    const double t = request.times[i];
    const std::string where = fmt::format("times[{}]", i);
    refuse_infinite(t, where);
    if (direction * (t - last) < 0 || direction * (request.t1 - t) < 0) {
      throw Error(Code::bad_params, fmt::format("{} is out of order", t), where,
                  fmt::format("give times in the order from {} to {}", t0, request.t1));
    }
    last = t;
  }
}

Checkpoint checkpoint_of(const Integrate::Checkpoint& c, const Equations& equations) {
  const size_t n = equations.size();
  if (c.state.size() != n || (!c.rate.empty() && c.rate.size() != n)) {
    throw Error(Code::bad_params, fmt::format("the checkpoint holds {} unknowns, not {}", c.state.size(), n),
                "resume", "send the checkpoint of an integration of these equations");
  }
  return {c.method, c.t,     c.state,     c.rate, {c.step, c.error, c.last_step, c.refused},
          c.origin, c.steps, c.reported_t};
}

Integrate::Checkpoint message_of(const Checkpoint& c) {
  Integrate::Checkpoint message;
  message.method = c.method;
  message.t = c.t;
  message.step = c.control.step;
  message.error = c.control.error;
  message.last_step = c.control.taken;
  message.refused = c.control.refused;
  message.origin = c.origin;
  message.reported_t = c.reported_t;
  message.steps = c.steps;
  message.state = c.y;
  message.rate = c.rate;
  return message;
}

// Everything that one request needs, from its texts to its reply.
class Integration {
 public:
  Integration(const Request& request, rpc::Suite& suite)
      : request_(request),
        adaptive_(wants_tolerance(request)),
        method_(chosen_method(request, adaptive_)),
        equations_(request.equations, named_values(request.constants, "constants"), registry_of(suite)),
        derivative_([this](double t, auto y, auto rate) { equations_.evaluate(t, y, rate); }) {}

  Integrate::Reply run(std::function<bool(double, int64_t)> go_on) {
    make_stepper();
    Goal goal;
    goal.t1 = request_.t1;
    goal.times = sample_times();
    goal.events = events();
    goal.most_steps = request_.max_steps;
    goal.most_time_s = request_.max_time_s;
    goal.go_on = std::move(go_on);
    if (request_.resume) goal.reported_t = request_.resume->reported_t;
    return reply(integrate(*stepper_, goal));
  }

 private:
  void make_stepper() {
    Problem problem{derivative_, request_.t0, {}, {}, {}};
    problem.jacobian = [this](double t, auto y, auto jacobian) { equations_.differentiate(t, y, jacobian); };
    problem.positions = [this] { return positions_of(equations_); };
    std::optional<Adaptive> steps;
    if (adaptive_) steps = Adaptive{tolerance_of(request_, equations_.size()), request_.step};
    if (request_.resume) {
      const Checkpoint from = checkpoint_of(*request_.resume, equations_);
      if (from.method != method_.name) {
        throw Error(Code::conflict,
                    fmt::format("the checkpoint is of {}, not of {}", from.method, method_.name), "resume",
                    "go on with the same method");
      }
      stepper_ = resumed_stepper(method_, problem, from, steps);
      return;
    }
    problem.y = equations_.arranged(named_values(request_.from, "from"));
    if (steps) {
      stepper_ = adaptive_stepper(method_, problem, *steps);
      return;
    }
    steps_ = EqualTimes::count(request_.t0, request_.t1, request_.step, request_.samples);
    const double effort = static_cast<double>(steps_) *
                          static_cast<double>(static_cast<size_t>(method_.stages) * equations_.size());
    if (effort > kLargestEffort) {
      throw Error(Code::limit, fmt::format("{} steps take too long", steps_), "step",
                  "take longer steps, or integrate in several requests");
    }
    stepper_ = equal_stepper(method_, problem, (request_.t1 - request_.t0) / static_cast<double>(steps_));
  }

  std::vector<double> sample_times() const {
    const double t0 = request_.resume ? request_.resume->reported_t : request_.t0;
    check_samples(request_, t0);
    if (!request_.times.empty()) return request_.times;
    // With equal steps exactly their ends, so that nothing need be interpolated.
    const int64_t samples = std::max<int64_t>(request_.samples, 1), parts = steps_ > 0 ? steps_ : samples;
    std::vector<double> times = {t0};
    for (int64_t i = 1; i < samples; ++i) {
      times.push_back(t0 + static_cast<double>(i * (parts / samples)) *
                               ((request_.t1 - t0) / static_cast<double>(parts)));
    }
    times.push_back(request_.t1);
    return times;
  }

  std::vector<EventRule> events() const {
    std::vector<EventRule> rules;
    for (const auto& [expression, crossing, terminal] : request_.events) {
      rules.push_back(
          {equations_.expression(expression, fmt::format("events[{}]", rules.size())), crossing, terminal});
    }
    return rules;
  }

  Integrate::Reply reply(Solution solution) const {
    if (!adaptive_ && solution.stop == Stop::not_finite) {
      throw Error(Code::diverged,
                  fmt::format("the solution leaves the finite numbers after t = {:.17g}", solution.t),
                  "equations", "look for a pole or a division by zero there, or take shorter steps");
    }
    const size_t columns = 1 + equations_.size();
    if (request_.times.empty() && solution.rows[solution.rows.size() - columns] != solution.t) {
      solution.rows.push_back(solution.t);
      solution.rows.insert(solution.rows.end(), solution.y.begin(), solution.y.end());
    }
    const auto rows = static_cast<int64_t>(solution.rows.size() / columns);
    Integrate::Reply reply;
    reply.names = equations_.unknowns();
    reply.samples = Array::inlined({rows, static_cast<int64_t>(columns)}, std::move(solution.rows));
    reply.steps = solution.steps;
    reply.evaluations = stepper_->evaluations();
    reply.refused = stepper_->refused();
    reply.stop = solution.stop;
    reply.t = solution.t;
    reply.state = std::move(solution.y);
    for (Occurrence& event : solution.events) {
      reply.events.push_back({static_cast<int64_t>(event.rule), event.t, event.rising, std::move(event.y)});
    }
    reply.checkpoint = message_of(solution.checkpoint);
    return reply;
  }

  const Request& request_;
  bool adaptive_;
  const Method& method_;
  Equations equations_;
  std::function<void(double, std::span<const double>, std::span<double>)> derivative_;
  std::unique_ptr<Stepper> stepper_;
  int64_t steps_ = 0;  // equal ones, in all; 0 of others
};

// Tells the caller how far it is, and stops when it is gone.
std::function<bool(double, int64_t)> watch_caller(const rpc::Service& service, rpc::ConnectionId caller,
                                                  const Request& request) {
  return [&service, caller, &request, told = Clock::now()](double t, int64_t steps) mutable {
    if (service.is_connected && !service.is_connected(caller)) return false;
    const auto now = Clock::now();
    if (request.progress_s <= 0 || now - told < std::chrono::duration<double>(request.progress_s))
      return true;
    told = now;
    const Progress::Request progress{t, request.t1, steps};
    service.notify(caller, rpc::codec<Progress>(), &progress);
    return true;
  };
}

}  // namespace

void add_integrate_message(rpc::Service& service, rpc::Suite& suite) {
  service.on<Integrate>([&service, &suite](const Request& request, rpc::Call& call) {
    if (request.equations.empty()) {
      throw Error(Code::bad_params, "there are no equations", "equations",
                  "give one an unknown, as \"x' = v\"");
    }
    check_interval(request);
    return Integration(request, suite).run(watch_caller(service, call.connection(), request));
  });
}

}  // namespace animado::fred
