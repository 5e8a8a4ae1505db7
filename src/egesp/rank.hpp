// The numerical rank: how many pivots complete pivoting finds above the tolerance.
#pragma once

#include "egesp/echelon.hpp"

namespace animado::egesp {

// a: (rows, columns), row-major, used up. threshold: T, relative to the largest element; 0 means max(rows,
// columns) · 2⁻⁵².
size_t rank(std::span<double> a, size_t rows, size_t columns, double threshold = 0);

}  // namespace animado::egesp
