// src/egesp/prepared.cpp, prepared_lanes.cpp: prepared systems give the bits of solve_batch, on every
// instruction set, in either layout, and refused systems leave their neighbours alone.
#include "egesp/prepared.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "systems.hpp"

namespace animado::egesp {
namespace {

class PreparedSystems : public testing::TestWithParam<std::tuple<InstructionSet, bool>> {
 protected:
  void SetUp() override {
    if (instructions() > widest_instruction_set()) GTEST_SKIP() << "not on this machine";
  }
  InstructionSet instructions() const { return std::get<0>(GetParam()); }
  PivotRule rule() const { return {std::get<1>(GetParam()), 0}; }
};

INSTANTIATE_TEST_SUITE_P(, PreparedSystems,
                         testing::Combine(testing::Values(InstructionSet::scalar, InstructionSet::sse2,
                                                          InstructionSet::avx2, InstructionSet::avx512),
                                          testing::Bool()),
                         [](const auto& tested) {
                           return std::string(
                                      kInstructionSetNames[static_cast<size_t>(std::get<0>(tested.param))]) +
                                  (std::get<1>(tested.param) ? "_complete" : "_partial");
                         });

TEST_P(PreparedSystems, GivesTheBitsOfSolveBatch) {
  Uniform uniform;
  for (size_t n : {1, 2, 6, 7, 15, 32, 33}) {
    for (size_t m : {1, 3}) {
      for (bool interleaved : {false, true}) {
        constexpr size_t kCount = 21;
        const auto a = random_numbers(uniform, kCount * n * n), b = random_numbers(uniform, kCount * n * m);
        std::vector<double> x(b.size()), expected(b.size());
        solve_batch({a, b, expected, kCount, n, m, interleaved}, rule(), InstructionSet::scalar);
        const auto systems = prepare({a, kCount, n, interleaved}, rule(), instructions());
        ASSERT_TRUE(systems->refused().empty());
        ASSERT_TRUE(systems->solve({b, m, interleaved}, x).empty());
        ASSERT_EQ(bits(x), bits(expected)) << "n " << n << " m " << m << " interleaved " << interleaved;
      }
    }
  }
}

// Matrices in one layout, right-hand sides in the other.
TEST_P(PreparedSystems, LayoutsMayDiffer) {
  Uniform uniform;
  constexpr size_t kCount = 11, n = 6;
  const auto a = random_numbers(uniform, kCount * n * n), b = random_numbers(uniform, kCount * n);
  std::vector<double> interleaved_b(b.size()), x(b.size()), interleaved_x(b.size());
  for (size_t s = 0; s < kCount; ++s) {
    for (size_t e = 0; e < n; ++e) interleaved_b[e * kCount + s] = b[s * n + e];
  }
  const auto systems = prepare({a, kCount, n, false}, rule(), instructions());
  systems->solve({b, 1, false}, x);
  systems->solve({interleaved_b, 1, true}, interleaved_x);
  for (size_t s = 0; s < kCount; ++s) {
    for (size_t e = 0; e < n; ++e) ASSERT_EQ(interleaved_x[e * kCount + s], x[s * n + e]);
  }
}

// Groups alike are kept once: what comes after them, and what comes back later, must not be mistaken for
// them.
TEST_P(PreparedSystems, SystemsAlikeAreToldFromOthers) {
  Uniform uniform;
  constexpr size_t kCount = 40, n = 6, kMatrix = n * n;
  const auto one = random_numbers(uniform, kMatrix), other = random_numbers(uniform, kMatrix);
  std::vector<double> a(kCount * kMatrix);
  for (size_t s = 0; s < kCount; ++s)
    std::ranges::copy(s < 16 || s >= 32 ? one : other, a.begin() + static_cast<ptrdiff_t>(s * kMatrix));
  const auto b = random_numbers(uniform, kCount * n);
  std::vector<double> x(b.size()), expected(b.size());
  solve_batch({a, b, expected, kCount, n, 1, false}, rule(), InstructionSet::scalar);
  prepare({a, kCount, n}, rule(), instructions())->solve({b, 1}, x);
  EXPECT_EQ(bits(x), bits(expected));
}

TEST_P(PreparedSystems, FactorsAgainInPlace) {
  Uniform uniform;
  constexpr size_t kCount = 20, n = 6;
  const std::vector<double> identity = [] {
    std::vector<double> a(kCount * n * n);
    for (size_t e = 0; e < a.size(); ++e) a[e] = e % (n * n) % (n + 1) == 0 ? 1 : 0;
    return a;
  }();
  const auto a = random_numbers(uniform, kCount * n * n), b = random_numbers(uniform, kCount * n);
  std::vector<double> x(b.size()), expected(b.size());
  const auto systems = prepare({identity, kCount, n}, rule(), instructions());
  systems->solve({b, 1}, x);
  EXPECT_EQ(bits(x), bits(b));
  systems->factor({a, kCount, n});
  systems->solve({b, 1}, x);
  solve_batch({a, b, expected, kCount, n, 1, false}, rule(), InstructionSet::scalar);
  EXPECT_EQ(bits(x), bits(expected));
}

TEST_P(PreparedSystems, RefusedSystemsAreNamedAndSpoilNoOther) {
  Uniform uniform;
  for (size_t n : {6, 9}) {
    constexpr size_t kCount = 19;
    auto a = random_numbers(uniform, kCount * n * n), b = random_numbers(uniform, kCount * n);
    for (size_t j = 0; j < n; ++j) a[5 * n * n + 3 * n + j] = a[5 * n * n + n + j];  // two rows alike
    a[18 * n * n] = std::nan("");
    std::vector<double> x(b.size()), expected(b.size());
    const auto systems = prepare({a, kCount, n}, rule(), instructions());
    ASSERT_FALSE(systems->refused().empty());
    EXPECT_EQ(systems->refused()[0].system, 5u);
    EXPECT_EQ(systems->refused()[0].pivot, n - 1);

    b[7 * n + 2] = HUGE_VAL;
    const auto refusals = systems->solve({b, 1}, x);
    const auto direct = solve_batch({a, b, expected, kCount, n, 1, false}, rule(), instructions());
    EXPECT_EQ(bits(x), bits(expected));
    ASSERT_EQ(refusals.size(), 3u);
    EXPECT_EQ(refusals[0].system, 5u);
    EXPECT_EQ(refusals[1].system, 7u);
    EXPECT_EQ(refusals[1].pivot, n);
    EXPECT_EQ(refusals[2].system, 18u);
    EXPECT_EQ(direct.size(), 3u);
  }
}

TEST(Prepared, AnEmptyBatchIsPrepared) {
  const auto systems = prepare({{}, 0, 6, true}, {});
  EXPECT_TRUE(systems->solve({{}, 1, true}, {}).empty());
}

// The reason for factors: x = A⁻¹ b of a Hilbert matrix has a residual that grows with its condition.
TEST(Prepared, IsBackwardStable) {
  for (size_t n = 2; n <= 12; ++n) {
    const std::vector<double> a = hilbert(n), b(n, 1.0);
    std::vector<double> x(n);
    ASSERT_TRUE(prepare({a, 1, n}, {false, 1e-300})->solve({b, 1}, x).empty());
    EXPECT_LT(backward_error(a.data(), b.data(), x.data(), n, 1), static_cast<double>(n) * 0x1p-53) << n;
  }
}

}  // namespace
}  // namespace animado::egesp
