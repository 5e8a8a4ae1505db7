// Prepared systems, dense: matrices that stay while right-hand sides change.
#pragma once

#include <optional>
#include <vector>

#include "egesp/protocol.batch.hpp"
#include "rpc/message.hpp"

namespace animado::egesp {

using rpc::Array;

struct Prepare {
  static constexpr auto name = "prepare"sv;
  static constexpr auto doc =
      "Factors a batch of matrices once, for many solve_prepared. The handle belongs to the connection and "
      "ends with it: "
      "a client whose server was restarted (code unknown_handle) prepares again. Singular as in solve."sv;
  struct Request {
    Array matrices;
    Pivoting pivoting = Pivoting::partial;
    double threshold = 0;
    Layout layout = Layout::systems;
    OnSingular on_singular = OnSingular::error;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrices", s.matrices,
            "A, shape (count, n, n), or (n, n) for one system; (n, n, count) in layout lanes");
      field("pivoting", s.pivoting, "partial or complete", rpc::kDefault);
      field("threshold", s.threshold, "T, as in solve", rpc::kDefault);
      field("layout", s.layout, "systems or lanes", rpc::kDefault);
      field("on_singular", s.on_singular,
            "error, or report: they are listed, and their solutions will be NaN", rpc::kDefault);
    }
  };
  struct Reply {
    int64_t handle = 0;
    std::vector<RefusedSystem> refused;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "names the systems in other messages of this connection");
      field("refused", s.refused, "the systems whose pivots were refused; empty unless on_singular is report",
            rpc::kDefault);
    }
  };
};

struct Refactor {
  static constexpr auto name = "refactor"sv;
  static constexpr auto doc =
      "Puts other matrices, as many and as large, in the place of prepared ones; pivoting and threshold "
      "stay. An error "
      "ends the handle."sv;
  struct Request {
    int64_t handle = 0;
    Array matrices;
    Layout layout = Layout::systems;
    OnSingular on_singular = OnSingular::error;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "of prepare");
      field("matrices", s.matrices, "A, as in prepare");
      field("layout", s.layout, "systems or lanes", rpc::kDefault);
      field("on_singular", s.on_singular, "error or report, as in prepare", rpc::kDefault);
    }
  };
  struct Reply {
    std::vector<RefusedSystem> refused;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("refused", s.refused, "as in prepare", rpc::kDefault);
    }
  };
};

struct SolvePrepared {
  static constexpr auto name = "solve_prepared"sv;
  static constexpr auto doc =
      "Solves A X = B with the matrices of a handle: the bits are those of solve, in a fraction of its time. "
      "Code unknown_handle "
      "when the connection prepared none of that name."sv;
  struct Request {
    int64_t handle = 0;
    Array right_sides;
    Layout layout = Layout::systems;
    OnSingular on_singular = OnSingular::error;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "of prepare");
      field("right_sides", s.right_sides,
            "B, shape (count, n, m), or (count, n) for one right-hand side each; (n, m, count) or (n, count) "
            "in layout lanes; (n) "
            "or (n, m) also for one system");
      field("layout", s.layout, "of right_sides and X: systems or lanes, whatever that of the matrices",
            rpc::kDefault);
      field("on_singular", s.on_singular, "error or report, as in solve", rpc::kDefault);
      field("out", s.out, "shared array for X, the shape of right_sides; inline reply when missing");
    }
  };
  struct Reply {
    Array solutions;
    std::vector<RefusedSystem> refused;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("solutions", s.solutions, "X, the shape of right_sides");
      field("refused", s.refused, "on request: the systems without a solution, in order", rpc::kDefault);
    }
  };
};

}  // namespace animado::egesp
