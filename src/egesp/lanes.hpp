// What the wide kernels are asked to do: many small systems of one size, side by side, one a lane. Plain
// types only, because lanes.cpp is compiled once for each instruction set and may share no inline function
// with the rest of the program.
#pragma once

#include <stddef.h>

namespace animado::egesp {

inline constexpr int kLaneSize =
    32;  // largest n and m of a kernel: a block of eight systems still fits the L2 cache
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
  double tolerance;  // a pivot must be larger than this times the largest element of its matrix
};

// The same arithmetic in the same order for each system, so the same bits, whatever the width.
void solve_lanes_sse2(const LaneBatch& batch);
void solve_lanes_avx2(const LaneBatch& batch);
void solve_lanes_avx512(const LaneBatch& batch);

}  // namespace animado::egesp
