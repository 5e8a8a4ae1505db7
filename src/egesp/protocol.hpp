// EGESP: linear systems. The messages, as the module's manual page. It knows no physics.
#pragma once

#include <array>
#include <optional>

#include "egesp/protocol.accuracy.hpp"
#include "egesp/protocol.batch.hpp"
#include "egesp/protocol.handles.hpp"
#include "egesp/protocol.least_squares.hpp"
#include "egesp/protocol.prepared.hpp"
#include "egesp/protocol.sparse.hpp"
#include "rpc/message.hpp"

namespace animado::egesp {

using rpc::Array;
using namespace std::string_view_literals;

struct Solve {
  static constexpr auto name = "solve"sv;
  static constexpr auto doc =
      "Solves A X = B for a batch of systems of one size by Gauss–Jordan elimination with pivoting. A "
      "singular system is an "
      "error (code singular) that names its index in the batch, the pivot reached and the size, unless the "
      "request asks that it be reported. Small "
      "systems go several at "
      "a time, large ones in blocks; the bits are the same."sv;
  struct Request {
    Array matrices, right_sides;
    Pivoting pivoting = Pivoting::partial;
    double threshold = 0;
    Layout layout = Layout::systems;
    OnSingular on_singular = OnSingular::error;
    std::optional<Array> out;
    bool residual = false, condition = false, refine = false;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrices", s.matrices,
            "A, shape (count, n, n), or (n, n) for one system; (n, n, count) in layout lanes");
      field("right_sides", s.right_sides,
            "B, shape (count, n, m), or (count, n) for one right-hand side each, or (n) or (n, m) for one "
            "system; (n, m, count) "
            "or (n, count) in layout lanes");
      field("pivoting", s.pivoting, "partial (row exchanges) or complete (rows and columns)", rpc::kDefault);
      field("threshold", s.threshold,
            "T: a pivot not larger than T times the largest element of its matrix is refused as singular; 0 "
            "refuses "
            "only what is lost in rounding (n · 2⁻⁵²)",
            rpc::kDefault);
      field("layout", s.layout, "systems or lanes", rpc::kDefault);
      field("on_singular", s.on_singular,
            "error, or report: systems without a solution are listed, their X is NaN, and the others are "
            "solved",
            rpc::kDefault);
      field("out", s.out, "shared array for X, the shape of right_sides; inline reply when missing");
      field("residual", s.residual, "tell the backward error of each system", rpc::kDefault);
      field("condition", s.condition, "tell the reciprocal condition of each system", rpc::kDefault);
      field("refine", s.refine, "one step of iterative refinement; tells the backward errors too",
            rpc::kDefault);
    }
  };
  struct Reply {
    Array solutions;
    std::vector<RefusedSystem> refused = {};
    std::optional<Accuracy> accuracy = {};
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("solutions", s.solutions, "X, the shape of right_sides");
      field("refused", s.refused, "on request: the systems without a solution, in order", rpc::kDefault);
      field("accuracy", s.accuracy, "on request");
    }
  };
};

struct Invert {
  static constexpr auto name = "invert"sv;
  static constexpr auto doc =
      "Inverts a batch of matrices; their determinants come with them. Singular as in solve."sv;
  struct Request {
    Array matrices;
    Pivoting pivoting = Pivoting::partial;
    double threshold = 0;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrices", s.matrices, "shape (count, n, n), or (n, n)");
      field("pivoting", s.pivoting, "partial or complete", rpc::kDefault);
      field("threshold", s.threshold, "T, as in solve", rpc::kDefault);
      field("out", s.out, "shared array for the inverses; inline reply when missing");
    }
  };
  struct Reply {
    Array inverses;
    std::vector<double> determinants;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("inverses", s.inverses, "the shape of matrices");
      field("determinants", s.determinants, "one a matrix");
    }
  };
};

struct Determinant {
  static constexpr auto name = "determinant"sv;
  static constexpr auto doc = "Determinants of a batch of matrices; 0 for a singular one."sv;
  struct Request {
    Array matrices;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrices", s.matrices, "shape (count, n, n), or (n, n)");
    }
  };
  struct Reply {
    std::vector<double> determinants;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("determinants", s.determinants, "one a matrix");
    }
  };
};

struct Rank {
  static constexpr auto name = "rank"sv;
  static constexpr auto doc = "Numerical ranks by complete pivoting."sv;
  struct Request {
    Array matrices;
    double threshold = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrices", s.matrices, "shape (count, rows, columns), or (rows, columns)");
      field("threshold", s.threshold, "T, relative to the largest element; 0 means max(rows, columns) · 2⁻⁵²",
            rpc::kDefault);
    }
  };
  struct Reply {
    std::vector<int64_t> ranks;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("ranks", s.ranks, "one a matrix");
    }
  };
};

using Messages = std::tuple<Solve, Prepare, SolvePrepared, Refactor, Invert, Determinant, Rank, LeastSquares,
                            SparseSolve, SparsePrepare, SparseRefactor, SparseSolvePrepared, Release>;

}  // namespace animado::egesp
