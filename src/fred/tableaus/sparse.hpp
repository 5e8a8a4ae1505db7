// Rows of a tableau of which most numbers are zero: each lists the others.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace animado::fred {

using Sparse = std::vector<std::pair<size_t, double>>;

inline std::vector<double> row(size_t size, const Sparse& entries) {
  std::vector<double> full(size);
  for (const auto& [at, value] : entries) full[at] = value;
  return full;
}

// Row after row, `columns` numbers each.
inline std::vector<double> flat(size_t columns, const std::vector<Sparse>& rows) {
  std::vector<double> all;
  for (const Sparse& entries : rows) {
    const auto full = row(columns, entries);
    all.insert(all.end(), full.begin(), full.end());
  }
  return all;
}

}  // namespace animado::fred
