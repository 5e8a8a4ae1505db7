// Sparse systems, one by one: the messages of the "ESparsos" in EGESP's name.
#pragma once

#include <array>
#include <optional>

#include "egesp/protocol.accuracy.hpp"

namespace animado::egesp {

enum class Format { triplets, csr, csc };
constexpr auto names(const Format*) {
  using namespace std::string_view_literals;
  return std::array{"triplets"sv, "csr"sv, "csc"sv};
}

enum class Order { amd, colamd, natural };
constexpr auto names(const Order*) {
  using namespace std::string_view_literals;
  return std::array{"amd"sv, "colamd"sv, "natural"sv};
}

struct SparseSystem {
  Format format = Format::triplets;
  int64_t size = 0;
  rpc::Array rows, columns, values;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("format", s.format,
          "triplets: row and column of each value, those given twice are added up; csr, csc: compressed rows "
          "or columns",
          rpc::kDefault);
    field("size", s.size, "n, the number of unknowns and of equations");
    field("rows", s.rows, "rows of the values, from 0; in csr the n + 1 starts of the rows");
    field("columns", s.columns, "columns of the values, from 0; in csc the n + 1 starts of the columns");
    field("values", s.values, "the elements that are not zero");
  }
};

struct SparseOptions {
  double threshold = 0.001;
  Order ordering = Order::amd;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("threshold", s.threshold,
          "T: the diagonal element is the pivot when its size is at least T times the largest of its column; "
          "1 always takes "
          "the largest, less keeps the factors sparser",
          rpc::kDefault);
    field("ordering", s.ordering, "which order of unknowns keeps the factors sparse", rpc::kDefault);
  }
};

struct SparseFacts {
  int64_t entries = 0, factor_entries = 0, blocks = 0;
  double pivot_ratio = 0;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("entries", s.entries, "of A, each place once");
    field("factor_entries", s.factor_entries, "of the factors L and U");
    field("blocks", s.blocks, "on the diagonal of the block triangular form");
    field("pivot_ratio", s.pivot_ratio,
          "the smallest pivot over the largest: when it is near 2⁻⁵² the system is close to a singular one; "
          "ask for condition");
  }
};

struct SparseSolve {
  static constexpr std::string_view name = "sparse_solve";
  static constexpr std::string_view doc =
      "Solves A X = B for one sparse matrix, by KLU: block triangular form, an ordering that keeps the "
      "factors sparse, "
      "elimination with the diagonal preferred. Code singular when no pivot is left, limit when the factors "
      "grow too large.";
  struct Request {
    SparseSystem matrix;
    rpc::Array right_sides;
    SparseOptions options;
    bool residual = false, condition = false, refine = false;
    std::optional<rpc::Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrix", s.matrix, "A");
      field("right_sides", s.right_sides, "B, shape (n) or (n, m)");
      field("options", s.options, "how A is factored", rpc::kDefault);
      field("residual", s.residual, "tell the backward error", rpc::kDefault);
      field("condition", s.condition, "tell the reciprocal condition", rpc::kDefault);
      field("refine", s.refine, "one step of iterative refinement; tells the backward error too",
            rpc::kDefault);
      field("out", s.out, "shared array for X, the shape of right_sides; inline reply when missing");
    }
  };
  struct Reply {
    rpc::Array solutions;
    SparseFacts facts;
    std::optional<Accuracy> accuracy = {};
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("solutions", s.solutions, "X, the shape of right_sides");
      field("facts", s.facts, "of the factors");
      field("accuracy", s.accuracy, "on request");
    }
  };
};

struct SparsePrepare {
  static constexpr std::string_view name = "sparse_prepare";
  static constexpr std::string_view doc =
      "Analyses and factors a sparse matrix and keeps the factors under a handle, which belongs to the "
      "connection and ends "
      "with it or with release. Errors as in sparse_solve; limit also when the connection keeps more than 1 "
      "GiB.";
  struct Request {
    SparseSystem matrix;
    SparseOptions options;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrix", s.matrix, "A");
      field("options", s.options, "how A is factored", rpc::kDefault);
    }
  };
  struct Reply {
    int64_t handle = 0;
    SparseFacts facts;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "for sparse_refactor, sparse_solve_prepared and release");
      field("facts", s.facts, "of the factors");
    }
  };
};

struct SparseRefactor {
  static constexpr std::string_view name = "sparse_refactor";
  static constexpr std::string_view doc =
      "Factors other values in the same places: the analysis stays, and the order of the pivots too unless "
      "it turned bad. Code "
      "unknown_handle when this connection does not hold it (prepare again), singular when the new matrix "
      "is.";
  struct Request {
    int64_t handle = 0;
    rpc::Array values;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "of sparse_prepare");
      field("values", s.values, "as many as were prepared, in their order");
    }
  };
  struct Reply {
    SparseFacts facts;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("facts", s.facts, "of the factors");
    }
  };
};

struct SparseSolvePrepared {
  static constexpr std::string_view name = "sparse_solve_prepared";
  static constexpr std::string_view doc =
      "Solves A X = B with the factors of a handle. Code unknown_handle as in sparse_refactor.";
  struct Request {
    int64_t handle = 0;
    rpc::Array right_sides;
    bool residual = false, condition = false, refine = false;
    std::optional<rpc::Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "of sparse_prepare");
      field("right_sides", s.right_sides, "B, shape (n) or (n, m)");
      field("residual", s.residual, "tell the backward error", rpc::kDefault);
      field("condition", s.condition, "tell the reciprocal condition", rpc::kDefault);
      field("refine", s.refine, "one step of iterative refinement; tells the backward error too",
            rpc::kDefault);
      field("out", s.out, "shared array for X, the shape of right_sides; inline reply when missing");
    }
  };
  using Reply = SparseSolve::Reply;
};

}  // namespace animado::egesp
