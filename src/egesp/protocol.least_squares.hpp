// Systems with more or fewer equations than unknowns, or without a unique solution.
#pragma once

#include <optional>

#include "rpc/message.hpp"

namespace animado::egesp {

struct LeastSquares {
  static constexpr std::string_view name = "least_squares";
  static constexpr std::string_view doc =
      "Finds X with the least ‖b − A x‖₂ for a matrix of any shape and rank, by Householder reflections with "
      "column pivoting, "
      "and says of what rank A is and how much of b is left over. A matrix that is rank-deficient is no "
      "error: its solutions "
      "differ by vectors of its null space, whose dimension the reply tells.";
  struct Request {
    rpc::Array matrix, right_sides;
    double threshold = 0;
    bool minimum_norm = false;
    std::optional<rpc::Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("matrix", s.matrix, "A, shape (rows, columns)");
      field("right_sides", s.right_sides, "B, shape (rows) or (rows, m)");
      field("threshold", s.threshold,
            "T: what is left of a column is taken for zero when it is not larger than T times the largest "
            "column; 0 means "
            "max(rows, columns) · 2⁻⁵²",
            rpc::kDefault);
      field("minimum_norm", s.minimum_norm,
            "of all solutions the one of least ‖x‖₂; else one with no more non-zero components than the rank",
            rpc::kDefault);
      field("out", s.out, "shared array for X, shape (columns) or (columns, m); inline reply when missing");
    }
  };
  struct Reply {
    rpc::Array solutions;
    int64_t rank = 0, null_space = 0;
    std::vector<double> residual_norms;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("solutions", s.solutions, "X, shape (columns) or (columns, m)");
      field("rank", s.rank, "numerical rank of A");
      field("null_space", s.null_space,
            "dimension of the null space, columns − rank: 0 when the solution is unique");
      field("residual_norms", s.residual_norms, "‖b − A x‖₂ of each right-hand side");
    }
  };
};

}  // namespace animado::egesp
