#include "fred/server.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "fred/equations.hpp"
#include "fred/integrate.hpp"
#include "fred/protocol.hpp"
#include "fred/stage.hpp"
#include "fred/tableau.hpp"
#include "rpc/destination.hpp"

namespace animado::fred {
namespace {

constexpr int64_t kLargestState = 1 << 28;  // numbers
constexpr double kLargestEffort =
    1e9;  // evaluated right-hand sides in one request: about a minute, while other callers wait
constexpr int64_t kLargestSamples = 1 << 22;  // numbers in a reply: 32 MiB

void refuse_infinite(double value, const std::string& where) {
  if (std::isfinite(value)) return;
  throw Error(Code::not_finite, fmt::format("{} is {}", where, value), where, "send finite numbers only");
}

Methods::Reply methods(const rpc::Nothing&) {
  Methods::Reply reply;
  for (const Tableau& t : tableaus()) {
    const auto stages = static_cast<int64_t>(t.stages());
    reply.methods.push_back({t.name, t.reference, t.order, stages, t.nodes, t.weights,
                             Array::inlined({stages, stages}, t.matrix)});
  }
  return reply;
}

// derivatives: (at least as many as `needed`, …the shape of state).
void check_shapes(const Array& state, const Array& derivatives, int64_t needed) {
  int64_t size = 1;
  for (int64_t extent : state.shape) {
    if (extent < 0 || (extent > 0 && size > kLargestState / extent)) {
      throw Error(Code::limit,
                  fmt::format("shape ({}) is not one of at most {} numbers", fmt::join(state.shape, ", "),
                              kLargestState),
                  "state", "split the state");
    }
    size *= extent;
  }
  const auto& shape = derivatives.shape;
  const bool fits = shape.size() == state.shape.size() + 1 && shape[0] >= needed &&
                    shape[0] <= kLargestState &&
                    std::equal(state.shape.begin(), state.shape.end(), shape.begin() + 1);
  if (!fits) {
    throw Error(Code::bad_shape,
                fmt::format("derivatives have shape ({}), the state ({})", fmt::join(shape, ", "),
                            fmt::join(state.shape, ", ")),
                "derivatives",
                fmt::format("send at least {} derivatives, each the shape of the state", needed));
  }
}

Stage::Reply stage(const Stage::Request& request, rpc::Call& call) {
  const Tableau& method = tableau_named(request.method);
  const auto stages = static_cast<int64_t>(method.stages());
  if (request.stage < 1 || request.stage > stages) {
    throw Error(Code::bad_params, fmt::format("{} has no stage {}", method.name, request.stage), "stage",
                fmt::format("stages 1 to {} are computed here; stage 0 is the state itself", stages));
  }
  refuse_infinite(request.step, "step");
  check_shapes(request.state, request.derivatives, request.stage);
  const auto state = call.read(request.state), derivatives = call.read(request.derivatives);
  rpc::Destination out(call, request.out, request.state.shape, {state, derivatives});
  combine(state, derivatives, method.coefficients(static_cast<size_t>(request.stage)), request.step,
          out.values());
  return {std::move(out).take()};
}

NamedValues named_values(const std::vector<Integrate::Value>& values, const char* where) {
  NamedValues named;
  for (const auto& [name, value] : values) {
    refuse_infinite(value, fmt::format("{}[{}]", where, named.size()));
    named.emplace_back(name, value);
  }
  return named;
}

Interval checked_interval(const Integrate::Request& request, const Tableau& method) {
  refuse_infinite(request.t0, "t0");
  refuse_infinite(request.t1, "t1");
  refuse_infinite(request.t1 - request.t0, "t1");
  refuse_infinite(request.step, "step");
  if (request.step < 0) {
    throw Error(Code::bad_params, fmt::format("the largest step is {}", request.step), "step",
                "give a length: the direction follows from t0 and t1");
  }
  const auto unknowns = static_cast<int64_t>(request.equations.size());
  if (request.samples < 0 || request.samples > kLargestSamples / (1 + unknowns)) {
    throw Error(Code::limit, fmt::format("{} samples", request.samples), "samples",
                fmt::format("ask for 0 to {} samples", kLargestSamples / (1 + unknowns)));
  }
  const Interval interval = Interval::divided(request.t0, request.t1, request.step, request.samples);
  const double effort =
      static_cast<double>(interval.steps) * static_cast<double>(method.stages() * request.equations.size());
  if (effort > kLargestEffort) {
    throw Error(Code::limit, fmt::format("{} steps take too long", interval.steps), "step",
                "take longer steps, or integrate in several requests");
  }
  return interval;
}

Integrate::Reply integrate_expressions(const Integrate::Request& request) {
  if (request.equations.empty()) {
    throw Error(Code::bad_params, "there are no equations", "equations",
                "give one an unknown, as \"x' = v\"");
  }
  const Tableau& method = tableau_named(request.method);
  const Interval interval = checked_interval(request, method);
  const Equations equations(request.equations, named_values(request.constants, "constants"));
  const auto start = equations.arranged(named_values(request.from, "from"));
  const Derivative derivative = [&](double t, auto y, auto rate) { equations.evaluate(t, y, rate); };
  Solution solution = integrate(derivative, start, interval, method);
  if (!solution.finite) {
    throw Error(Code::diverged,
                fmt::format("the solution leaves the finite numbers after t = {:.17g}",
                            interval.time(solution.steps)),
                "equations", "look for a pole or a division by zero there, or take shorter steps");
  }
  const auto columns = static_cast<int64_t>(1 + equations.size()),
             rows = static_cast<int64_t>(solution.rows.size()) / columns;
  return {equations.unknowns(), Array::inlined({rows, columns}, std::move(solution.rows)), solution.steps,
          solution.evaluations};
}

}  // namespace

void fill_table(rpc::Service& service, rpc::Suite&) {
  service.on<Methods>(methods).on<Stage>(stage).on<Integrate>(integrate_expressions);
}

}  // namespace animado::fred
