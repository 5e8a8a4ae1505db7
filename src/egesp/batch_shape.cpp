#include "egesp/batch_shape.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"

namespace animado::egesp {
namespace {

[[noreturn]] void refuse(const char* where, std::span<const int64_t> shape, const std::string& wanted) {
  throw Error(Code::bad_shape, fmt::format("shape ({}) is not {}", fmt::join(shape, ", "), wanted), where,
              fmt::format("send {} as {}", where, wanted));
}

size_t checked_extent(int64_t extent, int64_t least, int64_t most, const char* where, const char* what) {
  if (extent < least) {
    throw Error(Code::bad_shape, fmt::format("{} {}", extent, what), where,
                fmt::format("at least {} are needed", least));
  }
  if (extent > most) {
    throw Error(Code::limit, fmt::format("{} {} are more than {}", extent, what, most), where,
                "send smaller ones, or fewer at a time");
  }
  return static_cast<size_t>(extent);
}

}  // namespace

BatchShape matrices_shape(std::span<const int64_t> shape) {
  if (shape.size() != 2 && shape.size() != 3)
    refuse("matrices", shape, "(count, rows, columns) or (rows, columns)");
  const auto matrix = shape.last(2);
  return {shape.size() == 3 ? checked_extent(shape[0], 0, kLargestBatch, "matrices", "matrices") : 1,
          checked_extent(matrix[0], 1, kLargestSize, "matrices", "rows"),
          checked_extent(matrix[1], 1, kLargestSize, "matrices", "columns")};
}

BatchShape square_shape(std::span<const int64_t> shape, bool interleaved) {
  std::vector<int64_t> ordered(shape.begin(), shape.end());
  if (interleaved && shape.size() == 3) std::ranges::rotate(ordered, ordered.end() - 1);
  const char* wanted = interleaved ? "(n, n, count) or (n, n)" : "(count, n, n) or (n, n)";
  if (shape.size() != 2 && shape.size() != 3) refuse("matrices", shape, wanted);
  const BatchShape batch = matrices_shape(ordered);
  if (batch.rows != batch.columns) refuse("matrices", shape, wanted);
  return batch;
}

size_t right_sides(std::span<const int64_t> shape, std::span<const int64_t> matrices, bool interleaved) {
  const int64_t n = matrices[1];
  const bool single = matrices.size() == 2;
  const int64_t count = single ? 1 : interleaved ? matrices[2] : matrices[0];
  // One right-hand side has no extent of its own.
  const size_t plain = single ? 1 : 2;
  const bool with_m = shape.size() == plain + 1;
  if (with_m || shape.size() == plain) {
    const size_t at_n = single || interleaved ? 0 : 1, at_count = interleaved ? shape.size() - 1 : 0;
    if (shape[at_n] == n && (single || shape[at_count] == count)) {
      return with_m ? checked_extent(shape[at_n + 1], 1, kLargestSize, "right_sides", "right-hand sides") : 1;
    }
  }
  refuse("right_sides", shape,
         single        ? fmt::format("({0}) or ({0}, m)", n)
         : interleaved ? fmt::format("({0}, {1}) or ({0}, m, {1})", n, count)
                       : fmt::format("({1}, {0}) or ({1}, {0}, m)", n, count));
}

void check_work(const BatchShape& batch, size_t m) {
  const auto n = static_cast<double>(batch.rows), columns = static_cast<double>(batch.columns);
  const double work = static_cast<double>(batch.count) * n * columns * (columns / 3 + static_cast<double>(m));
  if (work > kLargestWork) {
    throw Error(Code::limit,
                fmt::format("about {:.2g} multiplications are more than {:.2g}", work, kLargestWork),
                "matrices", "send fewer systems at a time");
  }
}

}  // namespace animado::egesp
