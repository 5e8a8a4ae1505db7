// EGESP as other modules see it: typed calls over a channel.
#pragma once

#include "egesp/protocol.hpp"
#include "rpc/channel.hpp"

namespace animado::egesp {

class Client {
 public:
  explicit Client(rpc::Channel& channel) : channel_(channel) {}

  Solve::Reply solve(const Solve::Request& request) { return channel_.call<Solve>(request); }
  Invert::Reply invert(const Invert::Request& request) { return channel_.call<Invert>(request); }
  Determinant::Reply determinant(const Determinant::Request& request) {
    return channel_.call<Determinant>(request);
  }
  Rank::Reply rank(const Rank::Request& request) { return channel_.call<Rank>(request); }
  LeastSquares::Reply least_squares(const LeastSquares::Request& request) {
    return channel_.call<LeastSquares>(request);
  }
  SparseSolve::Reply sparse_solve(const SparseSolve::Request& request) {
    return channel_.call<SparseSolve>(request);
  }
  SparsePrepare::Reply sparse_prepare(const SparsePrepare::Request& request) {
    return channel_.call<SparsePrepare>(request);
  }
  SparseRefactor::Reply sparse_refactor(const SparseRefactor::Request& request) {
    return channel_.call<SparseRefactor>(request);
  }
  SparseSolvePrepared::Reply sparse_solve_prepared(const SparseSolvePrepared::Request& request) {
    return channel_.call<SparseSolvePrepared>(request);
  }
  void release(int64_t handle) { channel_.call<Release>({handle}); }

  // One system A x = b of b.size() equations, A row-major.
  std::vector<double> solve(std::vector<double> matrix, std::vector<double> right_side) {
    const auto n = static_cast<int64_t>(right_side.size());
    Solve::Request request;
    request.matrices = Array::inlined({n, n}, std::move(matrix));
    request.right_sides = Array::inlined({n}, std::move(right_side));
    return solve(request).solutions.values;
  }

 private:
  rpc::Channel& channel_;
};

}  // namespace animado::egesp
