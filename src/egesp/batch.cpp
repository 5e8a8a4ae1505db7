#include "egesp/batch.hpp"

#include <array>
#include <cassert>
#include <limits>

#include "egesp/gauss_jordan.hpp"
#include "egesp/lanes.hpp"

namespace animado::egesp {
namespace {

constexpr size_t kChunk = 512;  // interleaved systems between two looks at what was refused

class Solver {
 public:
  Solver(const Batch& batch, const PivotRule& rule) : batch_(batch), rule_(rule) {}

  std::vector<Refusal> run(InstructionSet instructions) {
    if (instructions == InstructionSet::scalar || batch_.n > kLaneSize || batch_.m > kLaneSize) {
      for (size_t s = 0; s < batch_.count; ++s) solve_alone(s);
    } else {
      solve_lanes_ = lane_kernels(instructions).solve;
      const size_t in_place = batch_.interleaved ? batch_.count / kLaneGroup * kLaneGroup : 0;
      for (size_t s = 0; s < in_place; s += kChunk) solve_in_place(s, std::min(kChunk, in_place - s));
      for (size_t s = in_place; s < batch_.count; s += kLaneGroup)
        solve_gathered(s, std::min(kLaneGroup, batch_.count - s));
    }
    return std::move(refusals_);
  }

 private:
  size_t at(size_t system, size_t element, size_t size) const {
    return batch_.interleaved ? element * batch_.count + system : system * size + element;
  }

  LaneBatch lanes(const double* matrices, const double* right_sides, double* solutions, size_t stride,
                  size_t count) {
    return {matrices,
            right_sides,
            solutions,
            solved_.data(),
            stride,
            count,
            static_cast<int>(batch_.n),
            static_cast<int>(batch_.m),
            rule_.complete,
            rule_.tolerance(batch_.n)};
  }

  void solve_in_place(size_t first, size_t count) {
    solve_lanes_(lanes(batch_.matrices.data() + first, batch_.right_sides.data() + first,
                       batch_.solutions.data() + first, batch_.count, count));
    revisit_refused(first, count);
  }

  // A group at a time, which stays in the L1 cache. The last system fills the lanes that are left over.
  void solve_gathered(size_t first, size_t count) {
    const size_t matrix = batch_.n * batch_.n, side = batch_.n * batch_.m;
    constexpr size_t stride = kLaneGroup;
    matrices_.resize(matrix * stride);
    right_sides_.resize(side * stride);
    solutions_.resize(side * stride);
    for (size_t lane = 0; lane < stride; ++lane) {
      const size_t s = first + std::min(lane, count - 1);
      for (size_t e = 0; e < matrix; ++e) matrices_[e * stride + lane] = batch_.matrices[at(s, e, matrix)];
      for (size_t e = 0; e < side; ++e) right_sides_[e * stride + lane] = batch_.right_sides[at(s, e, side)];
    }
    solve_lanes_(lanes(matrices_.data(), right_sides_.data(), solutions_.data(), stride, stride));
    for (size_t lane = 0; lane < count; ++lane) {
      for (size_t e = 0; e < side; ++e)
        batch_.solutions[at(first + lane, e, side)] = solutions_[e * stride + lane];
    }
    revisit_refused(first, count);
  }

  // The kernels only say that something was refused; alone, the same arithmetic tells what.
  void revisit_refused(size_t first, size_t count) {
    for (size_t lane = 0; lane < count; ++lane) {
      if (!solved_[lane]) solve_alone(first + lane);
    }
  }

  void solve_alone(size_t s) {
    const size_t matrix = batch_.n * batch_.n, side = batch_.n * batch_.m;
    matrices_.resize(matrix);
    right_sides_.resize(side);
    for (size_t e = 0; e < matrix; ++e) matrices_[e] = batch_.matrices[at(s, e, matrix)];
    for (size_t e = 0; e < side; ++e) right_sides_[e] = batch_.right_sides[at(s, e, side)];
    const Elimination outcome = gauss_jordan(matrices_, right_sides_, batch_.n, batch_.m, rule_);
    if (!outcome.solved()) {
      refusals_.push_back({s, outcome.pivots});
      std::ranges::fill(right_sides_, std::numeric_limits<double>::quiet_NaN());
    }
    for (size_t e = 0; e < side; ++e) batch_.solutions[at(s, e, side)] = right_sides_[e];
  }

  const Batch& batch_;
  const PivotRule& rule_;
  void (*solve_lanes_)(const LaneBatch&) = nullptr;
  std::array<long long, kChunk> solved_;
  std::vector<double> matrices_, right_sides_, solutions_;  // scratch
  std::vector<Refusal> refusals_;
};

}  // namespace

LaneKernels lane_kernels(InstructionSet instructions) {
  assert(instructions != InstructionSet::scalar);
  if (instructions == InstructionSet::avx512) return lanes_avx512();
  return instructions == InstructionSet::avx2 ? lanes_avx2() : lanes_sse2();
}

std::vector<Refusal> solve_batch(const Batch& batch, const PivotRule& rule, InstructionSet instructions) {
  assert(batch.matrices.size() == batch.count * batch.n * batch.n);
  assert(batch.right_sides.size() == batch.count * batch.n * batch.m &&
         batch.solutions.size() == batch.right_sides.size());
  return Solver(batch, rule).run(instructions);
}

}  // namespace animado::egesp
