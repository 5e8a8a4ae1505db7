#include "egesp/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "egesp/batch.hpp"
#include "egesp/batch_shape.hpp"
#include "egesp/determinant.hpp"
#include "egesp/invert.hpp"
#include "egesp/protocol.hpp"
#include "egesp/rank.hpp"
#include "rpc/destination.hpp"

namespace animado::egesp {
namespace {

PivotRule checked_rule(Pivoting pivoting, double threshold) {
  if (!(threshold >= 0 && threshold < 1)) {
    throw Error(Code::bad_params, fmt::format("the threshold is {}", threshold), "threshold",
                "T is a fraction of the largest element: at least 0, less than 1");
  }
  return {pivoting == Pivoting::complete, threshold};
}

void refuse_infinite(std::span<const double> numbers, const char* where) {
  const auto found = std::ranges::find_if_not(numbers, [](double v) { return std::isfinite(v); });
  if (found == numbers.end()) return;
  throw Error(Code::not_finite, fmt::format("element {} is {}", found - numbers.begin(), *found),
              fmt::format("{}[{}]", where, found - numbers.begin()), "send finite numbers only");
}

[[noreturn]] void refuse_system(const Refusal& refusal, size_t refused, size_t count, size_t n,
                                const PivotRule& rule) {
  const std::string where = fmt::format("matrices[{}]", refusal.system);
  const std::string others = refused > 1 ? fmt::format("; {} more are refused", refused - 1) : "";
  if (refusal.pivot == n) {
    throw Error(Code::not_finite,
                fmt::format("the solution of system {} of {} overflows{}", refusal.system, count, others),
                where, "scale its equations");
  }
  throw Error(Code::singular,
              fmt::format("system {} of {} is singular: pivot {} of size {} is not larger than {:.3g} times "
                          "its largest element{}",
                          refusal.system, count, refusal.pivot, n, rule.tolerance(n), others),
              where,
              "look for equations that depend on each other; a smaller threshold accepts smaller pivots");
}

Solve::Reply solve(const Solve::Request& request, rpc::Call& call) {
  const PivotRule rule = checked_rule(request.pivoting, request.threshold);
  const bool interleaved = request.layout == Layout::lanes;
  const BatchShape shape = square_shape(request.matrices.shape, interleaved);
  const size_t n = shape.rows,
               m = right_sides(request.right_sides.shape, request.matrices.shape, interleaved);
  check_work(shape, m);
  const auto matrices = call.read(request.matrices), sides = call.read(request.right_sides);
  rpc::Destination solutions(call, request.out, request.right_sides.shape, {matrices, sides});
  const auto refusals =
      solve_batch({matrices, sides, solutions.values(), shape.count, n, m, interleaved}, rule);
  if (!refusals.empty()) {
    // Numbers that are not finite end in a refusal too: they are looked for only then.
    refuse_infinite(matrices, "matrices");
    refuse_infinite(sides, "right_sides");
    refuse_system(refusals.front(), refusals.size(), shape.count, n, rule);
  }
  return {std::move(solutions).take()};
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
    if (!outcome.solved()) refuse_system({s, outcome.pivots}, 1, shape.count, n, rule);
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
  service.on<Solve>(solve).on<Invert>(invert_all).on<Determinant>(determinants).on<Rank>(ranks);
}

}  // namespace animado::egesp
