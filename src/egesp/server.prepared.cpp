// The messages of prepared dense systems: message → algorithm.
#include "egesp/prepared.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "egesp/batch_shape.hpp"
#include "egesp/protocol.hpp"
#include "egesp/server.checks.hpp"
#include "egesp/server.parts.hpp"
#include "rpc/destination.hpp"

namespace animado::egesp {
namespace {

constexpr std::string_view kKind = "prepared system";

// The shape of the matrices says which shapes right-hand sides may have.
struct KeptBatch final : Kept {
  std::unique_ptr<PreparedBatch> systems;
  PivotRule rule;
  bool single = false;  // one matrix of shape (n, n)

  size_t bytes() const override { return systems->bytes(); }
  std::vector<int64_t> shape(bool interleaved) const {
    const auto n = static_cast<int64_t>(systems->n()), count = static_cast<int64_t>(systems->count());
    if (single) return {n, n};
    return interleaved ? std::vector<int64_t>{n, n, count} : std::vector<int64_t>{count, n, n};
  }
};

// Request: Prepare's or Refactor's.
template <class Request>
Matrices matrices_of(const Request& request, rpc::Call& call) {
  const bool interleaved = request.layout == Layout::lanes;
  const BatchShape shape = square_shape(request.matrices.shape, interleaved);
  check_work(shape, 0);
  return {call.read(request.matrices), shape.count, shape.rows, interleaved};
}

std::vector<RefusedSystem> reported(const KeptBatch& kept, const Matrices& matrices, OnSingular on_singular) {
  const auto& refused = kept.systems->refused();
  if (!refused.empty() && on_singular == OnSingular::error) refuse_infinite(matrices.values, "matrices");
  return egesp::reported(refused, on_singular, matrices.count, matrices.n, kept.rule);
}

class PreparedMessages {
 public:
  explicit PreparedMessages(std::shared_ptr<Handles> handles) : handles_(std::move(handles)) {}

  Prepare::Reply prepare(const Prepare::Request& request, rpc::Call& call) {
    auto kept = std::make_unique<KeptBatch>();
    kept->rule = checked_rule(request.pivoting, request.threshold);
    const Matrices matrices = matrices_of(request, call);
    kept->single = request.matrices.shape.size() == 2;
    kept->systems = egesp::prepare(matrices, kept->rule);
    auto refused = reported(*kept, matrices, request.on_singular);
    return {handles_->keep(call.connection(), std::move(kept)), std::move(refused)};
  }

  Refactor::Reply refactor(const Refactor::Request& request, rpc::Call& call) {
    KeptBatch& kept = find(request.handle, call);
    const Matrices matrices = matrices_of(request, call);
    if (matrices.count != kept.systems->count() || matrices.n != kept.systems->n()) {
      throw Error(Code::bad_shape,
                  fmt::format("{} matrices of {} rows where {} of {} were prepared", matrices.count,
                              matrices.n, kept.systems->count(), kept.systems->n()),
                  "matrices", "send as many and as large ones, or prepare them under a handle of their own");
    }
    try {
      kept.systems->factor(matrices);
      return {reported(kept, matrices, request.on_singular)};
    } catch (...) {
      handles_->release(call.connection(), request.handle);
      throw;
    }
  }

  SolvePrepared::Reply solve(const SolvePrepared::Request& request, rpc::Call& call) {
    const KeptBatch& kept = find(request.handle, call);
    const bool interleaved = request.layout == Layout::lanes;
    const size_t m = right_sides(request.right_sides.shape, kept.shape(interleaved), interleaved);
    const auto sides = call.read(request.right_sides);
    rpc::Destination solutions(call, request.out, request.right_sides.shape, {sides});
    const auto refusals = kept.systems->solve({sides, m, interleaved}, solutions.values());
    if (!refusals.empty() && request.on_singular == OnSingular::error) refuse_infinite(sides, "right_sides");
    return {std::move(solutions).take(), egesp::reported(refusals, request.on_singular, kept.systems->count(),
                                                         kept.systems->n(), kept.rule)};
  }

 private:
  KeptBatch& find(int64_t handle, rpc::Call& call) {
    return handles_->find<KeptBatch>(call.connection(), handle, kKind);
  }

  std::shared_ptr<Handles> handles_;
};

}  // namespace

void add_prepared(rpc::Service& service, const std::shared_ptr<Handles>& handles) {
  const auto messages = std::make_shared<PreparedMessages>(handles);
  service
      .on<Prepare>(
          [messages](const Prepare::Request& r, rpc::Call& call) { return messages->prepare(r, call); })
      .on<Refactor>(
          [messages](const Refactor::Request& r, rpc::Call& call) { return messages->refactor(r, call); })
      .on<SolvePrepared>(
          [messages](const SolvePrepared::Request& r, rpc::Call& call) { return messages->solve(r, call); });
}

}  // namespace animado::egesp
