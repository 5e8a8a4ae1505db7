// Systems of which the matrices stay and the right-hand sides change: the matrices are factored once, P A Q =
// L U, and each solve is two substitutions.
//
// Factors and not inverses: both take n² multiplications a right-hand side; but A⁻¹ b has a backward error of
// κ(A) roundings where L and U have one of a few (Higham 2002, section 14.1), and the factors give the bits
// of `solve_batch`.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "egesp/batch.hpp"
#include "egesp/pivot_rule.hpp"

namespace animado::egesp {

struct Matrices {
  std::span<const double> values;  // (count, n, n), or (n, n, count) interleaved
  size_t count, n;
  bool interleaved = false;

  size_t at(size_t system, size_t element) const {
    return interleaved ? element * count + system : system * n * n + element;
  }
};

struct RightSides {
  std::span<const double> values;  // (count, n, m), or (n, m, count)
  size_t m;
  bool interleaved = false;

  size_t at(size_t count, size_t n, size_t system, size_t element) const {
    return interleaved ? element * count + system : system * n * m + element;
  }
};

class PreparedBatch {
 public:
  virtual ~PreparedBatch() = default;

  // Other matrices, as many and as large as at first, take the place of the old.
  virtual void factor(const Matrices& matrices) = 0;

  // The systems whose pivots were refused, in order.
  const std::vector<Refusal>& refused() const { return refused_; }

  // Returns the systems without a solution: the refused ones, and those whose solution is not finite. All of
  // such a system's solution is NaN. solutions: the shape of right_sides, apart from it.
  std::vector<Refusal> solve(const RightSides& right_sides, std::span<double> solutions) const;

  virtual size_t bytes() const = 0;
  size_t count() const { return count_; }
  size_t n() const { return n_; }

 protected:
  PreparedBatch(size_t count, size_t n, const PivotRule& rule) : rule_(rule), count_(count), n_(n) {}

  // False when a solution is not finite.
  virtual bool substitute(const RightSides& right_sides, std::span<double> solutions) const = 0;

  PivotRule rule_;
  size_t count_, n_;
  std::vector<Refusal> refused_;  // what `factor` leaves
};

std::unique_ptr<PreparedBatch> prepare(const Matrices& matrices, const PivotRule& rule,
                                       InstructionSet instructions = widest_instruction_set());

// Systems of any size, one by one.
std::unique_ptr<PreparedBatch> prepare_one_by_one(const Matrices& matrices, const PivotRule& rule);
// Systems of kLaneSize at most, through the kernels of lanes.hpp.
std::unique_ptr<PreparedBatch> prepare_in_lanes(const Matrices& matrices, const PivotRule& rule,
                                                const LaneKernels& kernels);

}  // namespace animado::egesp
