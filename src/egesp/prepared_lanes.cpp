// The factors lie in groups of eight systems, one group after the other, so that a solve reads them as one
// stream. A group like the one before it is not kept twice: bodies of one kind share their matrix, and a
// scene has many of a kind.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>

#include "egesp/aligned_memory.hpp"
#include "egesp/echelon.hpp"
#include "egesp/prepared.hpp"

namespace animado::egesp {
namespace {

// A group's place in memory: n² · 8 factors, then 2 n · 8 bytes for the order of rows and columns, to the end
// of a cache line.
size_t doubles_a_group(size_t n) {
  constexpr size_t kLine = 64 / sizeof(double);
  const size_t used = n * n * kLaneGroup + 2 * n * kLaneGroup / sizeof(double);
  return (used + kLine - 1) / kLine * kLine;
}

class InLanes final : public PreparedBatch {
 public:
  InLanes(const Matrices& matrices, const PivotRule& rule, const LaneKernels& kernels)
      : PreparedBatch(matrices.count, matrices.n, rule),
        kernels_(kernels),
        group_size_(doubles_a_group(n_)),
        groups_((count_ + kLaneGroup - 1) / kLaneGroup),
        memory_(groups_.size() * group_size_) {
    factor(matrices);
  }

  void factor(const Matrices& matrices) override {
    assert(matrices.count == count_ && matrices.n == n_);
    refused_.clear();
    double* place = memory_.numbers().data();
    for (size_t g = 0; g < groups_.size(); ++g) {
      factor_group(matrices, g * kLaneGroup, place);
      const bool repeats =
          g > 0 && std::memcmp(place, groups_[g - 1].factors, group_size_ * sizeof(double)) == 0;
      groups_[g] = repeats ? groups_[g - 1] : kept(place);
      if (!repeats) place += group_size_;
    }
  }

  size_t bytes() const override {
    return memory_.numbers().size_bytes() + groups_.size() * sizeof(LaneFactors);
  }

 private:
  size_t filled(size_t first) const { return std::min(kLaneGroup, count_ - first); }

  // The last system fills the lanes that are left over.
  void factor_group(const Matrices& matrices, size_t first, double* place) {
    scratch_.resize(n_ * n_ * kLaneGroup);
    for (size_t e = 0; e < n_ * n_; ++e) {
      for (size_t lane = 0; lane < kLaneGroup; ++lane) {
        const size_t s = first + std::min(lane, filled(first) - 1);
        scratch_[e * kLaneGroup + lane] = matrices.values[matrices.at(s, e)];
      }
    }
    std::array<double, 2 * kLaneSize * kLaneGroup> order;
    std::array<long long, kLaneGroup> solved;
    kernels_.factor({scratch_.data(), kLaneGroup, place, order.data(), solved.data(), static_cast<int>(n_),
                     rule_.complete, rule_.tolerance(n_)});
    std::fill(place + n_ * n_ * kLaneGroup, place + group_size_, 0.0);
    unsigned char* places = order_of(place);
    for (size_t k = 0; k < 2 * n_ * kLaneGroup; ++k) places[k] = static_cast<unsigned char>(order[k]);
    for (size_t lane = 0; lane < kLaneGroup; ++lane) {
      if (!solved[lane]) refuse_lane(first, lane, place);
    }
  }

  // The kernels only say that a pivot was refused; alone, the same arithmetic tells which.
  void refuse_lane(size_t first, size_t lane, double* place) {
    for (size_t k = 0; k < n_; ++k)
      place[(k * n_ + k) * kLaneGroup + lane] = std::numeric_limits<double>::quiet_NaN();
    if (lane >= filled(first)) return;
    std::vector<double> matrix(n_ * n_);
    for (size_t e = 0; e < matrix.size(); ++e) matrix[e] = scratch_[e * kLaneGroup + lane];
    refused_.push_back({first + lane, reduce_to_echelon(matrix, n_, n_, {}, 0, rule_).pivots});
  }

  unsigned char* order_of(double* place) const {
    return reinterpret_cast<unsigned char*>(place + n_ * n_ * kLaneGroup);
  }

  LaneFactors kept(double* place) const {
    const auto unless_in_order = [&](const unsigned char* order) {
      for (size_t k = 0; k < n_ * kLaneGroup; ++k) {
        if (order[k] != k / kLaneGroup) return order;
      }
      return static_cast<const unsigned char*>(nullptr);
    };
    const unsigned char* rows = order_of(place);
    return {place, unless_in_order(rows), unless_in_order(rows + n_ * kLaneGroup)};
  }

  bool substitute(const RightSides& right_sides, std::span<double> solutions) const override {
    const size_t in_place = right_sides.interleaved ? count_ / kLaneGroup : 0;  // groups
    const auto lanes = [&](size_t group, const double* b, double* x, size_t stride, size_t count) {
      return kernels_.substitute({groups_.data() + group, b, x, stride, count, static_cast<int>(n_),
                                  static_cast<int>(right_sides.m)});
    };
    bool finite = lanes(0, right_sides.values.data(), solutions.data(), count_, in_place * kLaneGroup);
    const size_t side = n_ * right_sides.m;
    std::vector<double> b(in_place < groups_.size() ? side * kLaneGroup : 0), x(b.size());
    for (size_t g = in_place; g < groups_.size(); ++g) {
      const size_t first = g * kLaneGroup;
      for (size_t e = 0; e < side; ++e) {
        for (size_t lane = 0; lane < filled(first); ++lane)
          b[e * kLaneGroup + lane] = right_sides.values[right_sides.at(count_, n_, first + lane, e)];
      }
      finite = lanes(g, b.data(), x.data(), kLaneGroup, kLaneGroup) && finite;
      for (size_t e = 0; e < side; ++e) {
        for (size_t lane = 0; lane < filled(first); ++lane)
          solutions[right_sides.at(count_, n_, first + lane, e)] = x[e * kLaneGroup + lane];
      }
    }
    return finite;
  }

  LaneKernels kernels_;
  size_t group_size_;  // doubles
  std::vector<LaneFactors> groups_;
  AlignedMemory memory_;
  std::vector<double> scratch_;
};

}  // namespace

std::unique_ptr<PreparedBatch> prepare_in_lanes(const Matrices& matrices, const PivotRule& rule,
                                                const LaneKernels& kernels) {
  return std::make_unique<InLanes>(matrices, rule, kernels);
}

}  // namespace animado::egesp
