// Solutions of a batch together with how good they are. Each system is factored by itself and keeps its
// factors for as long as it is examined; without refinement the solutions have the bits of solve_batch.
#pragma once

#include "egesp/batch.hpp"

namespace animado::egesp {

struct Questions {
  bool residual = false;   // the backward error of each system
  bool condition = false;  // the reciprocal condition of each
  bool refine = false;     // one step of refinement first
  bool any() const { return residual || condition || refine; }
};

// One number a system, NaN for a refused one; empty where it was not asked for. Refinement tells the backward
// errors too.
struct Examination {
  std::vector<double> backward_errors, reciprocal_conditions;
};

std::vector<Refusal> solve_examined(const Batch& batch, const PivotRule& rule, const Questions& questions,
                                    Examination& examination);

}  // namespace animado::egesp
