#include "egesp/sparse_matrix.hpp"

#include <fmt/format.h>

#include <cassert>
#include <numeric>

#include "base/error.hpp"

namespace animado::egesp {
namespace {

using Indices = std::vector<int>;

void check_count(const char* where, size_t found, size_t wanted) {
  if (found == wanted) return;
  throw Error(
      Code::bad_shape, fmt::format("{} numbers instead of {}", found, wanted), where,
      "triplets: as many rows and columns as values; csr and csc: n + 1 starts, as many indices as values");
}

// Numbers that are to be integers from 0 to `end`.
Indices integers(std::span<const double> numbers, int end, const char* where) {
  Indices found(numbers.size());
  for (size_t e = 0; e < numbers.size(); ++e) {
    if (!(numbers[e] >= 0 && numbers[e] <= end && numbers[e] == static_cast<int>(numbers[e]))) {
      throw Error(Code::bad_params, fmt::format("{} is not an integer from 0 to {}", numbers[e], end),
                  fmt::format("{}[{}]", where, e), "indices count from 0");
    }
    found[e] = static_cast<int>(numbers[e]);
  }
  return found;
}

// The line of each entry of compressed lines.
Indices expanded(std::span<const double> starts, int n, size_t count, const char* where) {
  check_count(where, starts.size(), static_cast<size_t>(n) + 1);
  const Indices ends = integers(starts, static_cast<int>(count), where);
  Indices lines(count);
  for (size_t line = 0; line < static_cast<size_t>(n); ++line) {
    if (ends[line + 1] < ends[line] || (line == 0 && ends[0] != 0)) {
      throw Error(Code::bad_params,
                  fmt::format("the starts {} and {} do not ascend from 0", ends[line], ends[line + 1]),
                  fmt::format("{}[{}]", where, line), "starts ascend from 0 to the number of values");
    }
    std::fill(lines.begin() + ends[line], lines.begin() + ends[line + 1], static_cast<int>(line));
  }
  if (static_cast<size_t>(ends.back()) != count) check_count(where, static_cast<size_t>(ends.back()), count);
  return lines;
}

Indices listed(std::span<const double> numbers, int n, size_t count, const char* where) {
  check_count(where, numbers.size(), count);
  return integers(numbers, n - 1, where);
}

// The order in which `lines` ascend; equals keep theirs. `order`: of entries, from an earlier sort.
Indices sorted_by(const Indices& lines, int n, const Indices& order) {
  Indices next(static_cast<size_t>(n) + 1);
  for (int line : lines) ++next[static_cast<size_t>(line) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  Indices sorted(order.size());
  for (int e : order)
    sorted[static_cast<size_t>(next[static_cast<size_t>(lines[static_cast<size_t>(e)])]++)] = e;
  return sorted;
}

}  // namespace

SparsePattern::SparsePattern(SparseFormat format, int64_t size, std::span<const double> rows,
                             std::span<const double> columns, size_t count)
    : places_(count) {
  if (size < 1 || size > kLargestSparseSize || count > kMostSparseEntries) {
    throw Error(size < 1 ? Code::bad_shape : Code::limit,
                fmt::format("{} unknowns and {} values", size, count), "size",
                fmt::format("1 to {} unknowns and at most {} values can be solved", kLargestSparseSize,
                            kMostSparseEntries));
  }
  const auto n = static_cast<int>(size);
  const Indices row_of =
      format == SparseFormat::csr ? expanded(rows, n, count, "rows") : listed(rows, n, count, "rows");
  const Indices column_of = format == SparseFormat::csc ? expanded(columns, n, count, "columns")
                                                        : listed(columns, n, count, "columns");
  Indices order(count);
  std::iota(order.begin(), order.end(), 0);
  order = sorted_by(column_of, n, sorted_by(row_of, n, order));

  pattern_.n = n;
  pattern_.starts.assign(static_cast<size_t>(n) + 1, 0);
  int last_row = -1, last_column = -1;
  for (int e : order) {
    const int row = row_of[static_cast<size_t>(e)], column = column_of[static_cast<size_t>(e)];
    if (row != last_row || column != last_column) {
      pattern_.rows.push_back(row);
      ++pattern_.starts[static_cast<size_t>(column) + 1];
      last_row = row, last_column = column;
    }
    places_[static_cast<size_t>(e)] = static_cast<int>(pattern_.rows.size()) - 1;
  }
  std::partial_sum(pattern_.starts.begin(), pattern_.starts.end(), pattern_.starts.begin());
}

SparseMatrix SparsePattern::matrix(std::span<const double> values) const {
  assert(values.size() == places_.size());
  SparseMatrix matrix = pattern_;
  matrix.values.assign(matrix.rows.size(), 0.0);
  for (size_t e = 0; e < values.size(); ++e) matrix.values[static_cast<size_t>(places_[e])] += values[e];
  return matrix;
}

}  // namespace animado::egesp
