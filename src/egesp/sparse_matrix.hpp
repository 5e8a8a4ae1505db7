// Sparse square matrices: from the three ways in which callers write them down to the one that is worked
// with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace animado::egesp {

// triplets: (row, column) of each value; what is given twice is added up. csr, csc: compressed rows or
// columns, where one of the two lists holds n + 1 starts and the other the indices. Indices count from 0.
enum class SparseFormat { triplets, csr, csc };

inline constexpr int kLargestSparseSize = 1 << 24;             // unknowns
inline constexpr size_t kMostSparseEntries = size_t{1} << 26;  // values: 0.5 GiB of them

// Compressed columns: rows ascend within a column, and no place stands there twice.
struct SparseMatrix {
  int n = 0;
  std::vector<int> starts, rows;
  std::vector<double> values;
};

// Where the values of a caller's list belong.
class SparsePattern {
 public:
  // rows, columns: as the format says, numbers that must be integers. count: of values. Throws bad_shape,
  // bad_params that names the first wrong index, limit.
  SparsePattern(SparseFormat format, int64_t size, std::span<const double> rows,
                std::span<const double> columns, size_t count);

  size_t count() const { return places_.size(); }
  size_t bytes() const {
    return (pattern_.starts.size() + pattern_.rows.size() + places_.size()) * sizeof(int);
  }
  SparseMatrix matrix(std::span<const double> values) const;

 private:
  SparseMatrix pattern_;     // without values
  std::vector<int> places_;  // of value e among those of the matrix
};

}  // namespace animado::egesp
