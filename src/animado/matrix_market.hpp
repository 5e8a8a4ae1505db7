// Matrices as files: the exchange format of NIST (Boisvert, Pozo, Remington, The Matrix Market Exchange
// Formats, NISTIR 5935, 1996), coordinate and array, real, integer and pattern, general, symmetric and
// skew-symmetric.
//
// A file comes from anywhere: nothing that it says about its size is believed before it is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace animado {

struct MarketMatrix {
  int64_t rows = 0, columns = 0;
  bool sparse = false;  // given by coordinates
  std::vector<double> at_row,
      at_column;               // sparse: where each value stands, from 0, symmetric halves filled in
  std::vector<double> values;  // else (rows, columns), row-major

  // The elements in row-major order, what stands twice added up. Throws limit when they are too many.
  std::vector<double> dense() const;
};

// Throws Error with file:line: syntax for what is no such file, not_finite for NaN and infinity, limit.
MarketMatrix read_matrix_market(const std::filesystem::path& file);
MarketMatrix parse_matrix_market(std::string_view text, const std::string& file);

// An array file, with the digits that it takes to read the same numbers back.
std::string matrix_market_text(int64_t rows, int64_t columns, std::span<const double> row_major);

}  // namespace animado
