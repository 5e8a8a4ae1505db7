// What the wide kernels are asked to do: many small systems of one size, side by side, one a lane. Plain
// types only, because lanes.cpp is compiled once for each instruction set and may share no inline function
// with the rest of the program.
#pragma once

#include <stddef.h>

namespace animado::egesp {

inline constexpr int kLaneSize = 32;     // largest n and m of a kernel: eight such systems fit the L2 cache
inline constexpr size_t kLaneGroup = 8;  // systems come in multiples of the widest register

// Element e of system s lies at e · stride + s.
struct LaneBatch {
  const double* matrices;     // (n, n, stride)
  const double* right_sides;  // (n, m, stride)
  double* solutions;          // (n, m, stride), apart from the two above
  long long* solved;  // (count): −1 where every pivot was accepted and the solution is finite, else 0
  size_t stride;
  size_t count;  // systems, a multiple of kLaneGroup, at most stride
  int n, m;
  bool complete;     // pivoting
  double tolerance;  // a pivot must be larger than this times the largest element of its matrix
};

// One group of kLaneGroup systems, taken apart once: P A Q = L U.
struct LaneFactoring {
  const double* matrices;  // (n, n, stride), of which the first kLaneGroup systems
  size_t stride;
  double*
      factors;  // (n, n, kLaneGroup) by columns: L below the diagonal, U above, on it the pivots' reciprocals
  double* order;      // (2, n, kLaneGroup): which row of A is row k of the factors, and which column
  long long* solved;  // (kLaneGroup): −1 where every pivot was accepted, else 0
  int n;
  bool complete;
  double tolerance;
};

// A group's factors as they are kept, and (n, kLaneGroup) numbers each: which row of A is row k, and which
// column. Null when they are in their order.
struct LaneFactors {
  const double* factors;
  const unsigned char *rows, *columns;
};

// Right-hand sides against factors. Bits are those of solving the systems at once.
struct LaneSubstitution {
  const LaneFactors* groups;  // of systems 0 … 7, 8 … 15, …
  const double* right_sides;  // (n, m, stride)
  double* solutions;          // (n, m, stride), apart from right_sides
  size_t stride;
  size_t count;  // systems, a multiple of kLaneGroup, at most stride
  int n, m;
};

// The same arithmetic in the same order for each system, so the same bits, whatever the width.
struct LaneKernels {
  void (*solve)(const LaneBatch& batch);
  void (*factor)(const LaneFactoring& group);
  bool (*substitute)(const LaneSubstitution& batch);  // false when a solution is not finite
};
LaneKernels lanes_sse2();
LaneKernels lanes_avx2();
LaneKernels lanes_avx512();

}  // namespace animado::egesp
