// FRED: ordinary differential equations over arrays or over a system of expressions. The messages, as the
// module's manual page. It knows no physics. docs/fred.md shows how it is used.
#pragma once

#include <array>
#include <optional>

#include "fred/vocabulary.hpp"
#include "rpc/message.hpp"

namespace animado::fred {

using rpc::Array;
using namespace std::string_view_literals;

constexpr auto names(const MethodKind*) {
  return std::array{"explicit_fixed"sv, "explicit_adaptive"sv, "symplectic"sv, "implicit"sv};
}

struct Methods {
  static constexpr auto name = "methods"sv;
  static constexpr auto doc = "Lists the methods, the explicit ones with their tableaus."sv;
  using Request = rpc::Nothing;
  struct Method {
    std::string name, reference;
    MethodKind kind = MethodKind::explicit_fixed;
    int64_t order = 0, error_order = 0, dense_order = 0, stages = 0, derivatives = 0;
    std::vector<double> nodes, weights, extra_nodes;
    Array matrix, errors;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "as given in other messages and in a scene's `method`");
      field("reference", s.reference, "where it comes from");
      field("kind", s.kind, "what it can do");
      field("order", s.order, "order of convergence");
      field("error_order", s.error_order, "of the embedded method that tells the error; 0 without one");
      field("dense_order", s.dense_order, "of the solution inside a step");
      field("stages", s.stages, "evaluations of the derivative a step");
      field("derivatives", s.derivatives,
            "that `dense` reads: the stages, the one at the end of the step, which is the first stage of the "
            "next, and "
            "those at the extra nodes; 0 without a tableau");
      field("nodes", s.nodes, "c: stage s is evaluated at t + c[s] h; empty without a tableau, as the next");
      field("weights", s.weights, "b");
      field("matrix", s.matrix, "a, shape (stages, stages), strictly lower");
      field("errors", s.errors,
            "e, shape (estimates, stages + 1): the error is h Σ e[j] k[j]; the last k is at the end of the "
            "step");
      field("extra_nodes", s.extra_nodes, "c of what `dense` needs beside");
    }
  };
  struct Reply {
    std::vector<Method> methods;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("methods", s.methods, "all of them");
    }
  };
};

struct Stage {
  static constexpr auto name = "stage"sv;
  static constexpr auto doc =
      "One stage of a step for a caller that owns the derivative: out = y + h Σ a[stage][j] k[j] for stage < "
      "stages, and the end "
      "of the step, out = y + h Σ b[j] k[j], for stage = stages; beyond it, where the extra derivatives of "
      "`dense` are "
      "wanted. Reads state and derivatives, writes out."sv;
  struct Request {
    std::string method = "rk4";
    int64_t stage = 0;
    double step = 0;
    Array state, derivatives;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("method", s.method, "name of an explicit method", rpc::kDefault);
      field("stage", s.stage, "1 … derivatives − 1 (stage 0 is the state itself)");
      field("step", s.step, "h");
      field("state", s.state, "y at the start of the step, any shape");
      field("derivatives", s.derivatives, "k, shape (at least `stage`, …the shape of state)");
      field("out", s.out, "shared array, the shape of state; inline reply when missing");
    }
  };
  struct Reply {
    Array state;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("state", s.state, "where the derivative is wanted next, or the end of the step");
    }
  };
};

struct Estimate {
  static constexpr auto name = "estimate"sv;
  static constexpr auto doc =
      "The error of a step that was made stage by stage, for a caller that chooses its steps by it. Accept "
      "the step when it is at "
      "most 1."sv;
  struct Request {
    std::string method;
    double step = 0, last_error = 1e-4, last_step = 0;
    bool last_refused = false, columns = false;
    Array state, end, derivatives;
    std::vector<double> absolute_tolerance, relative_tolerance;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("method", s.method, "name of an explicit_adaptive method");
      field("step", s.step, "h");
      field("state", s.state, "y at the start of the step");
      field("end", s.end, "y at its end, the shape of state");
      field("derivatives", s.derivatives,
            "k, shape (at least stages, …the shape of state); stages + 1, with that at the end, when the "
            "last of `errors` is not 0");
      field("absolute_tolerance", s.absolute_tolerance,
            "> 0: one number, or one of each element of the state");
      field("relative_tolerance", s.relative_tolerance, "≥ 0, likewise");
      field("last_error", s.last_error, "of the step that was accepted before, for PI control",
            rpc::kDefault);
      field("last_step", s.last_step, "its h, for prediction; 0 where there was none", rpc::kDefault);
      field("last_refused", s.last_refused,
            "whether the try before this one was refused: the next step then does not grow", rpc::kDefault);
      field(
          "columns", s.columns,
          "whether each index of the state's last axis is a system of its own, as a body: the error is that "
          "of the worst of them, not the mean over all",
          rpc::kDefault);
    }
  };
  struct Reply {
    double error = 0, next_step = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("error", s.error, "over the tolerance, root mean square; a huge number where it is not finite");
      field("next_step", s.next_step, "how long the next step, or the next try of this one, may be");
    }
  };
};

struct Dense {
  static constexpr auto name = "dense"sv;
  static constexpr auto doc =
      "The solution inside a step that was made stage by stage. Reads all but out, writes out."sv;
  struct Request {
    std::string method = "rk4";
    double step = 0, theta = 0;
    Array state, end, derivatives;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("method", s.method, "name of an explicit method", rpc::kDefault);
      field("step", s.step, "h");
      field("theta", s.theta, "where: at t + θ h, θ in [0, 1]");
      field("state", s.state, "y at the start of the step");
      field("end", s.end, "y at its end, the shape of state");
      field("derivatives", s.derivatives, "k, shape (derivatives of the method, …the shape of state)");
      field("out", s.out, "shared array, the shape of state; inline reply when missing");
    }
  };
  using Reply = Stage::Reply;
};

constexpr auto names(const Stop*) {
  return std::array{"end"sv,        "event"sv,    "step_limit"sv, "time_limit"sv, "step_too_small"sv,
                    "not_finite"sv, "cancelled"sv};
}

constexpr auto names(const Crossing*) {
  return std::array{"any"sv, "rising"sv, "falling"sv};
}

struct Integrate {
  static constexpr auto name = "integrate"sv;
  static constexpr auto doc =
      "Integrates a system of expressions, x' = …, from t0 to t1: with steps of one length, or as long as a "
      "tolerance allows. In "
      "the expressions t and the unknowns are known, the constants that the request gives, and the names "
      "that interexpserv "
      "holds, each with the value that it has when the request comes. Without a tolerance a solution that "
      "leaves the finite "
      "numbers is refused (diverged); else `stop` tells why the integration ended."sv;
  struct Value {
    std::string name;
    double value = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "an identifier");
      field("value", s.value, "its number");
    }
  };
  struct Event {
    std::string expression;
    Crossing crossing = Crossing::any;
    bool terminal = false;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("expression", s.expression, "happens where it crosses zero; \"a = b\" means a − b");
      field("crossing", s.crossing, "which way", rpc::kDefault);
      field("terminal", s.terminal, "whether the integration ends there", rpc::kDefault);
    }
  };
  struct Checkpoint {
    std::string method;
    double t = 0, step = 0, error = 1e-4, last_step = 0, origin = 0, reported_t = 0;
    bool refused = false;
    int64_t steps = 0;
    std::vector<double> state, rate;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("method", s.method, "of the integration");
      field("t", s.t, "where it goes on: the start of a step that neither the end nor an event cut short");
      field("state", s.state, "the unknowns there");
      field("rate", s.rate, "their derivatives; empty where they are not known yet");
      field("step", s.step, "the next one");
      field("error", s.error, "memory of the step control");
      field("last_step", s.last_step, "likewise: the length of the step before", rpc::kDefault);
      field("refused", s.refused, "likewise: the last try was refused");
      field("origin", s.origin, "equal steps are counted from here");
      field("steps", s.steps, "that were made since");
      field("reported_t", s.reported_t, "samples and events up to here were told before");
    }
  };
  struct Request {
    std::vector<std::string> equations;
    std::vector<Value> from, constants;
    double t0 = 0, t1 = 1, step = 0;
    std::string method;
    int64_t samples = 0;
    std::vector<double> times;
    double tolerance = 0;
    std::vector<double> absolute_tolerance, relative_tolerance;
    std::vector<Event> events;
    std::optional<Checkpoint> resume;
    int64_t max_steps = 10'000'000;
    double max_time_s = 60, progress_s = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("equations", s.equations,
            "one an unknown, as \"x' = v\", and definitions that they use, as \"f(x) = x^2\"");
      field("from", s.from, "the unknowns at t0; left out with `resume`", rpc::kDefault);
      field("constants", s.constants, "names that the equations use", rpc::kDefault);
      field("t0", s.t0, "start", rpc::kDefault);
      field("t1", s.t1, "end; may lie before t0");
      field("step", s.step,
            "largest step. Without a tolerance the interval is cut into equal ones, and 0 means a thousandth "
            "of it; with one, 0 "
            "means any",
            rpc::kDefault);
      field("method", s.method, "name of a method; empty: rk4, and dopri5 with a tolerance", rpc::kDefault);
      field("samples", s.samples, "rows of the reply beside the start, even in time; 0 means the end alone",
            rpc::kDefault);
      field("times", s.times, "instead of `samples`: a row at each of these, in the order from t0 to t1",
            rpc::kDefault);
      field("tolerance", s.tolerance,
            "of the error of a step, absolute and relative; 0 and none of the next two: equal steps",
            rpc::kDefault);
      field("absolute_tolerance", s.absolute_tolerance, "> 0: one number, or one of each unknown",
            rpc::kDefault);
      field("relative_tolerance", s.relative_tolerance, "≥ 0, likewise", rpc::kDefault);
      field("events", s.events, "what to look for on the way", rpc::kDefault);
      field("resume", s.resume,
            "the checkpoint of an earlier reply: goes on from there, to the same bits as without the "
            "interruption when equations, "
            "method and tolerances are the same; t0 is not looked at",
            rpc::kDefault);
      field("max_steps", s.max_steps, "at most so many steps", rpc::kDefault);
      field("max_time_s", s.max_time_s, "at most so long, on the clock", rpc::kDefault);
      field("progress_s", s.progress_s, "seconds between `progress` notifications to the caller; 0: none",
            rpc::kDefault);
    }
  };
  struct Happened {
    int64_t event = 0;
    double t = 0;
    bool rising = false;
    std::vector<double> state;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("event", s.event, "index into the request's events");
      field("t", s.t, "when");
      field("rising", s.rising, "which way it crossed");
      field("state", s.state, "the unknowns then");
    }
  };
  struct Reply {
    std::vector<std::string> names;
    Array samples;
    int64_t steps = 0, evaluations = 0, refused = 0;
    Stop stop = Stop::end;
    double t = 0;
    std::vector<double> state;
    std::vector<Happened> events;
    Checkpoint checkpoint;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "columns after t, in the order of the equations");
      field("samples", s.samples,
            "shape (rows, 1 + unknowns): t and the unknowns. Without `times` the first row is the start and "
            "the last is where the "
            "integration stopped");
      field("steps", s.steps, "steps taken");
      field("evaluations", s.evaluations, "evaluations of the right-hand side");
      field("refused", s.refused, "tries whose error was too large");
      field("stop", s.stop, "why it ended");
      field("t", s.t, "where it ended");
      field("state", s.state, "the unknowns there");
      field("events", s.events, "what happened, in the order of time");
      field("checkpoint", s.checkpoint, "to go on from");
    }
  };
};

struct Progress {
  static constexpr auto name = "progress"sv;
  static constexpr auto doc = "Notification: how far an `integrate` of this connection is."sv;
  struct Request {
    double t = 0, t1 = 0;
    int64_t steps = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("t", s.t, "reached");
      field("t1", s.t1, "wanted");
      field("steps", s.steps, "taken");
    }
  };
  using Reply = rpc::Nothing;
};

using Messages = std::tuple<Methods, Stage, Estimate, Dense, Integrate>;
using Notifications = std::tuple<Progress>;

}  // namespace animado::fred
