#include "egesp/prepared.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/finite.hpp"
#include "egesp/lu.hpp"

namespace animado::egesp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class OneByOne final : public PreparedBatch {
 public:
  OneByOne(const Matrices& matrices, const PivotRule& rule)
      : PreparedBatch(matrices.count, matrices.n, rule) {
    factor(matrices);
  }

  void factor(const Matrices& matrices) override {
    assert(matrices.count == count_ && matrices.n == n_);
    refused_.clear();
    systems_.clear();
    std::vector<double> a(n_ * n_);
    for (size_t s = 0; s < count_; ++s) {
      for (size_t e = 0; e < a.size(); ++e) a[e] = matrices.values[matrices.at(s, e)];
      const Lu& lu = systems_.emplace_back(a, n_, rule_);
      if (!lu.factored()) refused_.push_back({s, lu.pivots()});
    }
  }

  size_t bytes() const override {
    size_t sum = 0;
    for (const Lu& lu : systems_) sum += lu.bytes();
    return sum;
  }

 private:
  bool substitute(const RightSides& right_sides, std::span<double> solutions) const override {
    std::vector<double> b(n_ * right_sides.m);
    bool finite = true;
    for (size_t s = 0; s < count_; ++s) {
      for (size_t e = 0; e < b.size(); ++e) b[e] = right_sides.values[right_sides.at(count_, n_, s, e)];
      if (systems_[s].factored()) {
        systems_[s].solve(b, right_sides.m);
      } else {
        std::ranges::fill(b, kNan);
      }
      finite = finite && all_finite(b);
      for (size_t e = 0; e < b.size(); ++e) solutions[right_sides.at(count_, n_, s, e)] = b[e];
    }
    return finite;
  }

  std::vector<Lu> systems_;
};

}  // namespace

std::vector<Refusal> PreparedBatch::solve(const RightSides& right_sides, std::span<double> solutions) const {
  const size_t side = n_ * right_sides.m;
  assert(right_sides.values.size() == count_ * side && solutions.size() == right_sides.values.size());
  if (substitute(right_sides, solutions)) return {};
  std::vector<Refusal> without;
  auto refused = refused_.begin();
  for (size_t s = 0; s < count_; ++s) {
    const auto solution = [&](size_t e) -> double& { return solutions[right_sides.at(count_, n_, s, e)]; };
    bool finite = true;
    for (size_t e = 0; e < side; ++e) finite = finite && std::isfinite(solution(e));
    if (finite) continue;
    const bool singular = refused != refused_.end() && refused->system == s;
    without.push_back(singular ? *refused++ : Refusal{s, n_});
    for (size_t e = 0; e < side; ++e) solution(e) = kNan;
  }
  return without;
}

std::unique_ptr<PreparedBatch> prepare_one_by_one(const Matrices& matrices, const PivotRule& rule) {
  return std::make_unique<OneByOne>(matrices, rule);
}

std::unique_ptr<PreparedBatch> prepare(const Matrices& matrices, const PivotRule& rule,
                                       InstructionSet instructions) {
  assert(matrices.values.size() == matrices.count * matrices.n * matrices.n);
  if (instructions == InstructionSet::scalar || matrices.n > kLaneSize)
    return prepare_one_by_one(matrices, rule);
  return prepare_in_lanes(matrices, rule, lane_kernels(instructions));
}

}  // namespace animado::egesp
