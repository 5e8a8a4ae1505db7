// What the kernels for large matrices are asked to do. Plain types only: their sources (eliminate.cpp,
// eliminate_complete.cpp, substitute.cpp) are compiled once for each instruction set and may share no inline
// function with the rest of the program.
#pragma once

#include <stddef.h>

namespace animado::egesp {

// The downward sweep of echelon.hpp, on matrices in row-major order.
struct Reduction {
  double* a;  // (rows, columns); below the diagonal the factors stay
  size_t rows, columns;
  double* b;  // (rows, right_sides), swept along
  size_t right_sides;
  double floor;          // a pivot must be larger
  size_t* row_order;     // (rows): 0, 1, … from the caller; row k of the form is this row of A
  size_t* column_order;  // (columns): likewise; left alone by eliminate
  double* scratch;       // scratch_numbers(rows) of them, on a boundary of 64 bytes
  size_t pivots;         // accepted before one was refused
  bool odd;              // an odd number of exchanges
};

// One of the two triangles of a reduced matrix, and what it is applied to.
struct Substitution {
  const double* a;  // (n, n)
  size_t n;
  double* b;  // (n, m): becomes the solution
  size_t m;
  double* scratch;  // scratch_numbers(n) of them, on a boundary of 64 bytes
};

// For the columns of a panel, in groups of rows, and one strip of the rest.
constexpr size_t scratch_numbers(size_t rows) {
  return (rows + 16) * 66 + 2048;
}

// The same arithmetic in the same order for each element, so the same bits, from each.
struct BlockedKernels {
  void (*eliminate)(Reduction&);                     // partial pivoting
  void (*eliminate_complete)(Reduction&);            // complete pivoting
  void (*substitute_downward)(const Substitution&);  // L X = B, the diagonal of L is one
  void (*substitute_upward)(const Substitution&);    // U X = B
};

#define ANIMADO_BLOCKED_KERNELS(instructions)                                                  \
  namespace instructions {                                                                     \
  void eliminate(Reduction& reduction);                                                        \
  void eliminate_complete(Reduction& reduction);                                               \
  void substitute_downward(const Substitution& substitution);                                  \
  void substitute_upward(const Substitution& substitution);                                    \
  inline constexpr BlockedKernels kKernels{eliminate, eliminate_complete, substitute_downward, \
                                           substitute_upward};                                 \
  }
ANIMADO_BLOCKED_KERNELS(sse2)
ANIMADO_BLOCKED_KERNELS(avx2)
ANIMADO_BLOCKED_KERNELS(avx512)
#undef ANIMADO_BLOCKED_KERNELS

}  // namespace animado::egesp
