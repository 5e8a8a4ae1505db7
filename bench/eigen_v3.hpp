// Eigen as someone builds it who knows the processor: in a library of its own, so that none of its inline
// functions is taken for those of the rest.
#pragma once

#include <cstddef>

namespace animado::bench {

// x of A x = b by PartialPivLU; A column by column.
[[gnu::visibility("default")]] void eigen_v3_solve(const double* a, const double* b, double* x, size_t n);

}  // namespace animado::bench
