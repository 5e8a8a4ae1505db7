#include "egesp/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "egesp/batch_shape.hpp"
#include "egesp/determinant.hpp"
#include "egesp/examined.hpp"
#include "egesp/invert.hpp"
#include "egesp/protocol.hpp"
#include "egesp/rank.hpp"
#include "egesp/server.checks.hpp"
#include "egesp/server.parts.hpp"
#include "rpc/destination.hpp"

namespace animado::egesp {
namespace {

Solve::Reply solve(const Solve::Request& request, rpc::Call& call) {
  const PivotRule rule = checked_rule(request.pivoting, request.threshold);
  const bool interleaved = request.layout == Layout::lanes;
  const BatchShape shape = square_shape(request.matrices.shape, interleaved);
  const size_t n = shape.rows,
               m = right_sides(request.right_sides.shape, request.matrices.shape, interleaved);
  check_work(shape, m);
  const auto matrices = call.read(request.matrices), sides = call.read(request.right_sides);
  rpc::Destination solutions(call, request.out, request.right_sides.shape, {matrices, sides});
  const Batch batch{matrices, sides, solutions.values(), shape.count, n, m, interleaved};
  const Questions questions{request.residual, request.condition, request.refine};
  Examination examination;
  const auto refusals =
      questions.any() ? solve_examined(batch, rule, questions, examination) : solve_batch(batch, rule);
  if (!refusals.empty() && request.on_singular == OnSingular::error) {
    // Numbers that are not finite end in a refusal too: they are looked for only then.
    refuse_infinite(matrices, "matrices");
    refuse_infinite(sides, "right_sides");
  }
  Solve::Reply reply{std::move(solutions).take(),
                     reported(refusals, request.on_singular, shape.count, n, rule)};
  if (questions.any()) {
    reply.accuracy =
        accuracy_of(std::move(examination.backward_errors), std::move(examination.reciprocal_conditions));
  }
  return reply;
}

Invert::Reply invert_all(const Invert::Request& request, rpc::Call& call) {
  const PivotRule rule = checked_rule(request.pivoting, request.threshold);
  const BatchShape shape = square_shape(request.matrices.shape);
  const size_t n = shape.rows;
  check_work(shape, n);
  const auto matrices = call.read(request.matrices);
  refuse_infinite(matrices, "matrices");
  rpc::Destination inverses(call, request.out, request.matrices.shape, {matrices});
  std::vector<double> scratch(n * n), determinants;
  for (size_t s = 0; s < shape.count; ++s) {
    std::ranges::copy(matrices.subspan(s * n * n, n * n), scratch.begin());
    const Elimination outcome = invert(scratch, inverses.values().subspan(s * n * n, n * n), n, rule);
    if (!outcome.solved()) reported({{s, outcome.pivots}}, OnSingular::error, shape.count, n, rule);
    determinants.push_back(outcome.determinant);
  }
  return {std::move(inverses).take(), std::move(determinants)};
}

// Applies `measure` to a copy of each matrix.
template <class Result, class Measure>
std::vector<Result> measured(const rpc::Array& array, const BatchShape& shape, rpc::Call& call,
                             const Measure& measure) {
  check_work(shape, 0);
  const auto matrices = call.read(array);
  refuse_infinite(matrices, "matrices");
  const size_t size = shape.rows * shape.columns;
  std::vector<double> scratch(size);
  std::vector<Result> results;
  for (size_t s = 0; s < shape.count; ++s) {
    std::ranges::copy(matrices.subspan(s * size, size), scratch.begin());
    results.push_back(static_cast<Result>(measure(std::span(scratch))));
  }
  return results;
}

Determinant::Reply determinants(const Determinant::Request& request, rpc::Call& call) {
  const BatchShape shape = square_shape(request.matrices.shape);
  return {
      measured<double>(request.matrices, shape, call, [&](auto a) { return determinant(a, shape.rows); })};
}

Rank::Reply ranks(const Rank::Request& request, rpc::Call& call) {
  const double threshold = checked_rule(Pivoting::complete, request.threshold).threshold;
  const BatchShape shape = matrices_shape(request.matrices.shape);
  return {measured<int64_t>(request.matrices, shape, call,
                            [&](auto a) { return rank(a, shape.rows, shape.columns, threshold); })};
}

}  // namespace

void fill_table(rpc::Service& service, rpc::Suite&) {
  const auto handles = std::make_shared<Handles>();
  service.on<Solve>(solve).on<Invert>(invert_all).on<Determinant>(determinants).on<Rank>(ranks);
  add_least_squares(service);
  add_prepared(service, handles);
  add_sparse(service, handles);
  service.on<Release>([handles](const Release::Request& request, rpc::Call& call) {
    handles->release(call.connection(), request.handle);
    return rpc::Nothing{};
  });
  service.on_disconnect = [handles](rpc::ConnectionId connection) { handles->end(connection); };
}

}  // namespace animado::egesp
