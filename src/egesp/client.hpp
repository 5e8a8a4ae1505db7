// EGESP as other modules see it: typed calls over a channel.
#pragma once

#include "egesp/protocol.hpp"
#include "rpc/channel.hpp"
#include "rpc/prepared.hpp"

namespace animado::egesp {

// Matrices that are prepared when they are first needed, and again when the server was restarted and does not
// know them any more. The arrays of the request must keep their numbers until the last solve.
class PreparedSystems {
 public:
  PreparedSystems(rpc::Channel& channel, Prepare::Request matrices)
      : channel_(channel), matrices_(std::move(matrices)) {}

  // The request needs no handle: it is filled in.
  SolvePrepared::Reply solve(SolvePrepared::Request& request) {
    if (!prepared_) prepare();
    return rpc::ask_prepared([this] { prepare(); },
                             [&] {
                               request.handle = handle_;
                               return channel_.call<SolvePrepared>(request);
                             });
  }

 private:
  void prepare() {
    handle_ = channel_.call<Prepare>(matrices_).handle;
    prepared_ = true;
  }

  rpc::Channel& channel_;
  Prepare::Request matrices_;
  int64_t handle_ = 0;
  bool prepared_ = false;
};

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
