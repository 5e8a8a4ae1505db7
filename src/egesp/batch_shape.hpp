// What the shapes of a request say: how many matrices of what size, and how many right-hand sides.
#pragma once

#include <cstdint>
#include <span>

namespace animado::egesp {

inline constexpr int64_t kLargestSize = 4096;      // rows or columns: 128 MiB a matrix
inline constexpr int64_t kLargestBatch = 1 << 28;  // systems
inline constexpr double kLargestWork =
    2e11;  // multiplications in one request: about a minute, while other callers wait

struct BatchShape {
  size_t count, rows, columns;
};

// (count, rows, columns) or (rows, columns), each matrix of `work` multiplications at most. Throws bad_shape,
// limit.
BatchShape matrices_shape(std::span<const int64_t> shape);

// The same for square matrices; interleaved: (n, n, count) or (n, n).
BatchShape square_shape(std::span<const int64_t> shape, bool interleaved = false);

// How many right-hand sides: the protocol's shapes of right_sides beside (count, n, n), (n, n, count) or (n,
// n).
size_t right_sides(std::span<const int64_t> shape, std::span<const int64_t> matrices, bool interleaved);

// Throws limit when the elimination of that many matrices, beside m further columns, takes too long.
void check_work(const BatchShape& batch, size_t m);

}  // namespace animado::egesp
