// The sparse messages and release: message → algorithm.
#include <fmt/format.h>

#include "base/error.hpp"
#include "egesp/accuracy.hpp"
#include "egesp/protocol.hpp"
#include "egesp/server.checks.hpp"
#include "egesp/server.parts.hpp"
#include "egesp/sparse_lu.hpp"
#include "rpc/destination.hpp"

namespace animado::egesp {
namespace {

constexpr std::string_view kSparseKind = "prepared sparse system";

// A pattern beside the factors of values in it.
struct PreparedSparse final : Kept {
  SparsePattern pattern;
  SparseLu lu;

  PreparedSparse(SparsePattern places, std::span<const double> values, const SparseRule& rule)
      : pattern(std::move(places)), lu(pattern.matrix(values), rule) {}
  size_t bytes() const override { return lu.bytes() + pattern.bytes(); }
};

SparseRule rule_of(const SparseOptions& options) {
  if (!(options.threshold > 0 && options.threshold <= 1)) {
    throw Error(Code::bad_params, fmt::format("the threshold is {}", options.threshold), "options.threshold",
                "T, the preference for the diagonal, is more than 0 and at most 1");
  }
  return {options.threshold, static_cast<Ordering>(options.ordering)};
}

std::unique_ptr<PreparedSparse> prepared(const SparseSystem& system, const SparseOptions& options,
                                         rpc::Call& call) {
  const SparseRule rule = rule_of(options);
  const auto values = call.read(system.values);
  refuse_infinite(values, "matrix.values");
  SparsePattern pattern(static_cast<SparseFormat>(system.format), system.size, call.read(system.rows),
                        call.read(system.columns), values.size());
  return std::make_unique<PreparedSparse>(std::move(pattern), values, rule);
}

SparseFacts facts_of(const SparseLu& lu) {
  const SparseLu::Facts facts = lu.facts();
  return {facts.entries, facts.factor_entries, facts.blocks, facts.pivot_ratio};
}

// Request: SparseSolve's or SparseSolvePrepared's.
template <class Request>
SparseSolve::Reply solution(const Request& request, const SparseLu& lu, rpc::Call& call) {
  const size_t m = right_sides_of(request.right_sides.shape, static_cast<int64_t>(lu.size()));
  const auto sides = call.read(request.right_sides);
  refuse_infinite(sides, "right_sides");
  rpc::Destination solutions(call, request.out, request.right_sides.shape, {sides});
  const std::span<double> x = solutions.values();
  std::ranges::copy(sides, x.begin());
  lu.solve(x, m);
  refuse_overflow(x);
  if (request.refine) refine(lu, sides, x, m);
  std::vector<double> errors, conditions;
  if (request.refine || request.residual) errors.push_back(backward_error(lu, sides, x, m));
  if (request.condition) conditions.push_back(reciprocal_condition(lu));
  SparseSolve::Reply reply{std::move(solutions).take(), facts_of(lu)};
  if (!errors.empty() || !conditions.empty())
    reply.accuracy = accuracy_of(std::move(errors), std::move(conditions));
  return reply;
}

SparseSolve::Reply solve_once(const SparseSolve::Request& request, rpc::Call& call) {
  return solution(request, prepared(request.matrix, request.options, call)->lu, call);
}

class SparseMessages {
 public:
  explicit SparseMessages(std::shared_ptr<Handles> handles) : handles_(std::move(handles)) {}

  SparsePrepare::Reply prepare(const SparsePrepare::Request& request, rpc::Call& call) {
    auto system = prepared(request.matrix, request.options, call);
    const SparseFacts facts = facts_of(system->lu);
    return {handles_->keep(call.connection(), std::move(system)), facts};
  }

  SparseRefactor::Reply refactor(const SparseRefactor::Request& request, rpc::Call& call) {
    PreparedSparse& system = find(request.handle, call);
    const auto values = call.read(request.values);
    refuse_infinite(values, "values");
    if (values.size() != system.pattern.count()) {
      throw Error(Code::bad_shape,
                  fmt::format("{} values instead of {}", values.size(), system.pattern.count()), "values",
                  "send as many values as were prepared, in their order");
    }
    system.lu.refactor(system.pattern.matrix(values).values);
    return {facts_of(system.lu)};
  }

  SparseSolve::Reply solve(const SparseSolvePrepared::Request& request, rpc::Call& call) {
    return solution(request, find(request.handle, call).lu, call);
  }

 private:
  PreparedSparse& find(int64_t handle, rpc::Call& call) {
    return handles_->find<PreparedSparse>(call.connection(), handle, kSparseKind);
  }

  std::shared_ptr<Handles> handles_;
};

}  // namespace

void add_sparse(rpc::Service& service, const std::shared_ptr<Handles>& handles) {
  const auto messages = std::make_shared<SparseMessages>(handles);
  service.on<SparseSolve>(solve_once)
      .on<SparsePrepare>(
          [messages](const auto& request, rpc::Call& call) { return messages->prepare(request, call); })
      .on<SparseRefactor>(
          [messages](const auto& request, rpc::Call& call) { return messages->refactor(request, call); })
      .on<SparseSolvePrepared>(
          [messages](const auto& request, rpc::Call& call) { return messages->solve(request, call); });
}

}  // namespace animado::egesp
