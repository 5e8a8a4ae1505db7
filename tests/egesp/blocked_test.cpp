// src/egesp/eliminate.cpp, eliminate_complete.cpp, substitute.cpp: the blocked kernels of each instruction
// set give the bits of the plain loops, whatever the size.
#include "egesp/blocked.hpp"

#include <gtest/gtest.h>

#include "egesp/gauss_jordan.hpp"
#include "egesp/lu.hpp"
#include "systems.hpp"

namespace animado::egesp {
namespace {

class EveryKernel : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (GetParam() > widest_instruction_set()) GTEST_SKIP() << "not on this machine";
  }
};

std::string name_of(const testing::TestParamInfo<InstructionSet>& tested) {
  return std::array{"scalar", "sse2", "avx2", "avx512"}[static_cast<size_t>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(, EveryKernel,
                         testing::Values(InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512),
                         name_of);

// Sizes around the panel's width and the tiles' edges; small integers make many pivots equal.
TEST_P(EveryKernel, GivesTheBitsOfThePlainLoops) {
  Uniform uniform;
  for (const bool complete : {false, true}) {
    for (const size_t n : {49, 63, 64, 65, 71, 128, 131}) {
      for (const size_t m : {1, 5, 26}) {
        auto a = random_numbers(uniform, n * n), b = random_numbers(uniform, n * m);
        if (n == 71) std::ranges::transform(a, a.begin(), [](double v) { return std::round(2 * v); });
        const PivotRule rule{complete, 1e-300};
        auto plain_a = a, plain_b = b, blocked_a = a, blocked_b = b, later_b = b;
        const auto plain = gauss_jordan(plain_a, plain_b, n, m, rule, InstructionSet::scalar);
        const auto blocked = gauss_jordan(blocked_a, blocked_b, n, m, rule, GetParam());
        ASSERT_TRUE(plain.solved());
        EXPECT_EQ(blocked.determinant, plain.determinant);
        EXPECT_EQ(blocked_a, plain_a) << n << (complete ? " complete" : " partial");
        EXPECT_EQ(blocked_b, plain_b) << n << "x" << m << (complete ? " complete" : " partial");
        Lu(a, n, rule, GetParam()).solve(later_b, m);
        EXPECT_EQ(later_b, plain_b) << n << "x" << m << (complete ? " complete" : " partial");
      }
    }
  }
}

TEST_P(EveryKernel, ReducesMatricesOfAnyShape) {
  Uniform uniform;
  using Shape = std::pair<size_t, size_t>;
  for (const auto& [rows, columns] : {Shape{150, 70}, {70, 150}, {3, 200}, {200, 3}}) {
    for (const bool complete : {false, true}) {
      const auto a = random_numbers(uniform, rows * columns), b = random_numbers(uniform, rows * 2);
      auto plain_a = a, plain_b = b, blocked_a = a, blocked_b = b;
      const PivotRule rule{.complete = complete};
      const Echelon plain =
          reduce_to_echelon(plain_a, rows, columns, plain_b, 2, rule, InstructionSet::scalar);
      const Echelon blocked = reduce_to_echelon(blocked_a, rows, columns, blocked_b, 2, rule, GetParam());
      EXPECT_EQ(blocked.pivots, std::min(rows, columns));
      EXPECT_EQ(blocked.rows, plain.rows);
      EXPECT_EQ(blocked.columns, plain.columns);
      EXPECT_EQ(blocked.odd, plain.odd);
      EXPECT_EQ(blocked_a, plain_a) << rows << "x" << columns;
      EXPECT_EQ(blocked_b, plain_b) << rows << "x" << columns;
    }
  }
}

// The last equation but `left` are sums of those before it: the pivot after them is refused.
TEST_P(EveryKernel, NamesTheRefusedPivot) {
  Uniform uniform;
  constexpr size_t n = 100;
  for (const size_t rank : {0, 1, 63, 64, 99}) {
    std::vector<double> a(n * n), b(n, 1.0);
    for (size_t i = 0; i < rank; ++i) {
      for (size_t j = 0; j < n; ++j) a[i * n + j] = i == j ? 4 : std::round(uniform(-1, 1));
    }
    for (size_t i = rank; rank > 0 && i < n; ++i)
      std::copy_n(a.begin(), n, a.begin() + static_cast<ptrdiff_t>(i * n));
    for (const bool complete : {false, true}) {
      auto reduced = a;
      EXPECT_EQ(gauss_jordan(reduced, b, n, 1, {complete, 1e-10}, GetParam()).pivots, rank) << complete;
    }
  }
}

}  // namespace
}  // namespace animado::egesp
