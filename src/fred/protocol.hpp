// FRED: ordinary differential equations by Runge–Kutta methods. The messages, as the module's manual page. It knows no physics.
#pragma once

#include <optional>

#include "rpc/message.hpp"

namespace animado::fred {

using rpc::Array;
using namespace std::string_view_literals;

struct Methods {
  static constexpr auto name = "methods"sv;
  static constexpr auto doc = "Lists the methods with their tableaus."sv;
  using Request = rpc::Nothing;
  struct Method {
    std::string name, reference;
    int64_t order = 0, stages = 0;
    std::vector<double> nodes, weights;
    Array matrix;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "as given in other messages and in a scene's `method`");
      field("reference", s.reference, "where it comes from");
      field("order", s.order, "order of convergence");
      field("stages", s.stages, "evaluations of the derivative a step");
      field("nodes", s.nodes, "c: stage s is evaluated at t + c[s] h");
      field("weights", s.weights, "b");
      field("matrix", s.matrix, "a, shape (stages, stages), strictly lower");
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
      "One stage of a step for a caller that owns the derivative: out = y + h Σ a[stage][j] k[j] for stage < stages, and the end "
      "of the step, out = y + h Σ b[j] k[j], for stage = stages. Reads state and derivatives, writes out."sv;
  struct Request {
    std::string method = "rk4";
    int64_t stage = 0;
    double step = 0;
    Array state, derivatives;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("method", s.method, "name of a method", rpc::kDefault);
      field("stage", s.stage, "1 … stages (stage 0 is the state itself)");
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

struct Integrate {
  static constexpr auto name = "integrate"sv;
  static constexpr auto doc =
      "Integrates a system of expressions, x' = …, from t0 to t1 with a fixed step and returns samples. In the expressions t and "
      "the unknowns are known, and the constants that the request gives."sv;
  struct Value {
    std::string name;
    double value = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "an identifier");
      field("value", s.value, "its number");
    }
  };
  struct Request {
    std::vector<std::string> equations;
    std::vector<Value> from, constants;
    double t0 = 0, t1 = 1, step = 0;
    std::string method = "rk4";
    int64_t samples = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("equations", s.equations, "one an unknown, as \"x' = v\"");
      field("from", s.from, "the unknowns at t0");
      field("constants", s.constants, "names that the equations use", rpc::kDefault);
      field("t0", s.t0, "start", rpc::kDefault);
      field("t1", s.t1, "end; may lie before t0");
      field("step", s.step, "largest step; the interval is cut into equal ones. 0 means a thousandth of it", rpc::kDefault);
      field("method", s.method, "name of a method", rpc::kDefault);
      field("samples", s.samples, "rows of the reply beside the start, evenly spread over the steps; 0 means the end alone",
            rpc::kDefault);
    }
  };
  struct Reply {
    std::vector<std::string> names;
    Array samples;
    int64_t steps = 0, evaluations = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "columns after t, in the order of the equations");
      field("samples", s.samples, "shape (rows, 1 + unknowns): t and the unknowns; the first row is the start, the last the end");
      field("steps", s.steps, "steps taken");
      field("evaluations", s.evaluations, "evaluations of the right-hand side");
    }
  };
};

using Messages = std::tuple<Methods, Stage, Integrate>;

}  // namespace animado::fred
