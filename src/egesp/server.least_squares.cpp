// least_squares: message → algorithm.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "egesp/batch_shape.hpp"
#include "egesp/least_squares.hpp"
#include "egesp/protocol.hpp"
#include "egesp/server.checks.hpp"
#include "egesp/server.parts.hpp"
#include "rpc/destination.hpp"

namespace animado::egesp {
namespace {

// Long and thin matrices are what this is for: a limit on each extent would refuse them.
constexpr int64_t kMostElements = kLargestSize * kLargestSize;

void check_shape(std::span<const int64_t> shape) {
  if (shape.size() != 2 || shape[0] < 1 || shape[1] < 1) {
    throw Error(Code::bad_shape, fmt::format("shape ({}) is not (rows, columns)", fmt::join(shape, ", ")),
                "matrix", "send one matrix of at least one row and one column");
  }
  const double work = 2.0 * static_cast<double>(shape[0]) * static_cast<double>(shape[1]) *
                      static_cast<double>(std::min(shape[0], shape[1]));
  if (shape[0] > kMostElements || shape[1] > kMostElements / shape[0] || work > kLargestWork) {
    throw Error(Code::limit, fmt::format("a matrix of {} × {} is too large", shape[0], shape[1]), "matrix",
                fmt::format("at most {} elements and {:.2g} multiplications are allowed", kMostElements,
                            kLargestWork));
  }
}

LeastSquares::Reply answer(const LeastSquares::Request& request, rpc::Call& call) {
  const auto& shape = request.matrix.shape;
  check_shape(shape);
  const auto rows = static_cast<size_t>(shape[0]), columns = static_cast<size_t>(shape[1]);
  const size_t m = right_sides_of(request.right_sides.shape, shape[0]);
  const auto a = call.read(request.matrix), b = call.read(request.right_sides);
  refuse_infinite(a, "matrix");
  refuse_infinite(b, "right_sides");
  std::vector<int64_t> solution_shape = request.right_sides.shape;
  solution_shape[0] = shape[1];
  rpc::Destination solutions(call, request.out, std::move(solution_shape), {a, b});
  const auto found =
      least_squares({a, b, rows, columns, m, checked_threshold(request.threshold), request.minimum_norm});
  refuse_overflow(found.x);
  std::ranges::copy(found.x, solutions.values().begin());
  const auto rank = static_cast<int64_t>(found.rank);
  return {std::move(solutions).take(), rank, shape[1] - rank, found.residual_norms};
}

}  // namespace

void add_least_squares(rpc::Service& service) {
  service.on<LeastSquares>(answer);
}

}  // namespace animado::egesp
