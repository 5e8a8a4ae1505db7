#include "egesp/rank.hpp"

namespace animado::egesp {

size_t rank(std::span<double> a, size_t rows, size_t columns, double threshold) {
  return reduce_to_echelon(a, rows, columns, {}, 0, {.complete = true, .threshold = threshold}).pivots;
}

}  // namespace animado::egesp
