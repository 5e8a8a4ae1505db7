// Steps by callers that own the derivative.
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "fred/embedded.hpp"
#include "fred/methods.hpp"
#include "fred/protocol.hpp"
#include "fred/server.messages.hpp"
#include "fred/stage.hpp"
#include "rpc/destination.hpp"

namespace animado::fred {
namespace {

constexpr int64_t kLargestState = 1 << 28;  // numbers

const Tableau& explicit_method(const std::string& name) {
  const Method& method = method_named(name);
  if (method.tableau != nullptr) return *method.tableau;
  throw Error(Code::bad_params, fmt::format("{} has no stages that could be made one by one", method.name),
              "method", "use an explicit Runge–Kutta method, or send the equations with `integrate`");
}

void check_state(const Array& state) {
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
}

// derivatives: (at least as many as `needed`, …the shape of state).
void check_shapes(const Array& state, const Array& derivatives, int64_t needed) {
  check_state(state);
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

void check_end(const Array& state, const Array& end) {
  if (state.shape == end.shape) return;
  throw Error(Code::bad_shape,
              fmt::format("the end has shape ({}), the state ({})", fmt::join(end.shape, ", "),
                          fmt::join(state.shape, ", ")),
              "end", "send the state at the end of the step");
}

Stage::Reply stage(const Stage::Request& request, rpc::Call& call) {
  const Tableau& method = explicit_method(request.method);
  const auto last = static_cast<int64_t>(method.derivatives()) - 1;
  if (request.stage < 1 || request.stage > last) {
    throw Error(Code::bad_params, fmt::format("{} has no stage {}", method.name, request.stage), "stage",
                fmt::format("stages 1 to {} are computed here; stage 0 is the state itself", last));
  }
  refuse_infinite(request.step, "step");
  check_shapes(request.state, request.derivatives, request.stage);
  const auto state = call.read(request.state), derivatives = call.read(request.derivatives);
  rpc::Destination out(call, request.out, request.state.shape, {state, derivatives});
  combine(state, derivatives, method.places[static_cast<size_t>(request.stage)].sum, request.step,
          out.values());
  return {std::move(out).take()};
}

Estimate::Reply estimate(const Estimate::Request& request, rpc::Call& call) {
  const Tableau& method = explicit_method(request.method);
  if (!method.is_adaptive()) {
    throw Error(Code::bad_params, fmt::format("{} does not know its error", method.name), "method",
                "use an explicit_adaptive one, as dopri5");
  }
  refuse_infinite(request.step, "step");
  refuse_infinite(request.last_error, "last_error");
  refuse_infinite(request.last_step, "last_step");
  if (request.last_step * request.step < 0) {
    throw Error(Code::bad_params,
                fmt::format("the last step, {:g}, went the other way than this one", request.last_step),
                "last_step", "send a length of the step's sign, or 0");
  }
  const size_t needed = method.stages() + (method.error_reads_end() ? 1 : 0);
  check_shapes(request.state, request.derivatives, static_cast<int64_t>(needed));
  check_end(request.state, request.end);
  const auto state = call.read(request.state), end = call.read(request.end);
  const Tolerance tolerance =
      checked_tolerance(request.absolute_tolerance, request.relative_tolerance, state.size());
  const size_t systems = request.columns && !request.state.shape.empty() && !state.empty()
                             ? static_cast<size_t>(request.state.shape.back())
                             : 1;
  const double error =
      step_error(method, state, end, call.read(request.derivatives), request.step, tolerance, systems);
  StepControl control(method.error_order);
  control.memory().error = std::max(request.last_error, kLeastError);
  control.memory().taken = request.last_step;
  control.memory().refused = request.last_refused;
  control.accept(error, request.step);
  return {std::isfinite(error) ? error : std::numeric_limits<double>::max(), control.memory().step};
}

Dense::Reply dense(const Dense::Request& request, rpc::Call& call) {
  const Tableau& method = explicit_method(request.method);
  refuse_infinite(request.step, "step");
  if (!(request.theta >= 0 && request.theta <= 1)) {
    throw Error(Code::bad_params, fmt::format("θ is {}", request.theta), "theta", "it lies between 0 and 1");
  }
  check_shapes(request.state, request.derivatives, static_cast<int64_t>(method.derivatives()));
  check_end(request.state, request.end);
  const auto state = call.read(request.state), end = call.read(request.end);
  const auto derivatives = call.read(request.derivatives);
  rpc::Destination out(call, request.out, request.state.shape, {state, end, derivatives});
  dense_output(method, state, end, derivatives, request.step, request.theta, out.values());
  return {std::move(out).take()};
}

}  // namespace

void add_stage_messages(rpc::Service& service) {
  service.on<Stage>(stage).on<Estimate>(estimate).on<Dense>(dense);
}

}  // namespace animado::fred
