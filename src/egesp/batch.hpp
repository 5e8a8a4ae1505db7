// A X = B for many systems of one size. Small ones go several at a time through the wide kernels (lanes.hpp),
// others one by one through gauss_jordan; the solutions have the same bits either way.
#pragma once

#include <span>
#include <vector>

#include "egesp/instruction_set.hpp"
#include "egesp/lanes.hpp"
#include "egesp/pivot_rule.hpp"

namespace animado::egesp {

struct Batch {
  std::span<const double> matrices;     // (count, n, n), or (n, n, count) interleaved
  std::span<const double> right_sides;  // (count, n, m), or (n, m, count)
  std::span<double> solutions;          // the shape of right_sides, apart from both
  size_t count, n, m;
  bool interleaved = false;  // the systems run fastest: element e of system s lies at e · count + s
};

// A system that was not solved; its solution is NaN.
struct Refusal {
  size_t system;
  size_t pivot;  // the index of the refused pivot; n when all were accepted and the solution overflowed
};

LaneKernels lane_kernels(InstructionSet instructions);  // of any but scalar

// The systems that were refused, in order; the others are solved whatever happened to these. Numbers that are
// not finite make their system refused.
std::vector<Refusal> solve_batch(const Batch& batch, const PivotRule& rule,
                                 InstructionSet instructions = widest_instruction_set());

}  // namespace animado::egesp
