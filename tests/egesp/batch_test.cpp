// src/egesp/batch.cpp and lanes.cpp: every instruction set gives the bits of the scalar elimination, in
// either layout, and refused systems leave their neighbours alone.
#include "egesp/batch.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "egesp/gauss_jordan.hpp"
#include "systems.hpp"

namespace animado::egesp {
namespace {

struct Systems {
  size_t count, n, m;
  bool interleaved;
  std::vector<double> a, b, x;

  Systems(size_t count_, size_t n_, size_t m_, bool interleaved_, Uniform& uniform)
      : count(count_),
        n(n_),
        m(m_),
        interleaved(interleaved_),
        a(random_numbers(uniform, count * n * n)),
        b(random_numbers(uniform, count * n * m)),
        x(b.size()) {}

  size_t at(size_t system, size_t element, size_t size) const {
    return interleaved ? element * count + system : system * size + element;
  }
  std::vector<double> one(const std::vector<double>& all, size_t system) const {
    std::vector<double> numbers(all.size() / count);
    for (size_t e = 0; e < numbers.size(); ++e) numbers[e] = all[at(system, e, numbers.size())];
    return numbers;
  }
  std::vector<Refusal> solve(InstructionSet instructions, PivotRule rule = {}) {
    return solve_batch({a, b, x, count, n, m, interleaved}, rule, instructions);
  }
};

class EveryInstructionSet : public testing::TestWithParam<std::tuple<InstructionSet, bool>> {
 protected:
  void SetUp() override {
    if (instructions() > widest_instruction_set()) GTEST_SKIP() << "not on this machine";
  }
  InstructionSet instructions() const { return std::get<0>(GetParam()); }
  PivotRule rule(double threshold = 0) const { return {std::get<1>(GetParam()), threshold}; }
};

INSTANTIATE_TEST_SUITE_P(, EveryInstructionSet,
                         testing::Combine(testing::Values(InstructionSet::scalar, InstructionSet::sse2,
                                                          InstructionSet::avx2, InstructionSet::avx512),
                                          testing::Bool()),
                         [](const auto& tested) {
                           return std::string(
                                      kInstructionSetNames[static_cast<size_t>(std::get<0>(tested.param))]) +
                                  (std::get<1>(tested.param) ? "_complete" : "_partial");
                         });

// Sizes with a kernel of their own, sizes without, the largest, and one beyond; batches that end inside a
// register.
TEST_P(EveryInstructionSet, GivesTheBitsOfGaussJordan) {
  Uniform uniform;
  for (size_t n : {1, 2, 3, 4, 5, 6, 7, 8, 15, 16, 31, 32, 33}) {
    for (size_t m : {1, 4}) {
      for (bool interleaved : {false, true}) {
        Systems systems(77, n, m, interleaved, uniform);
        ASSERT_TRUE(systems.solve(instructions(), rule()).empty());
        for (size_t s = 0; s < systems.count; ++s) {
          auto a = systems.one(systems.a, s), b = systems.one(systems.b, s);
          gauss_jordan(a, b, n, m, rule());
          ASSERT_EQ(bits(systems.one(systems.x, s)), bits(b)) << "n " << n << " m " << m << " system " << s;
        }
      }
    }
  }
}

// The first of equals, row by row: partial pivoting takes its row, complete pivoting its row and its column.
TEST_P(EveryInstructionSet, TiesGoToTheFirst) {
  Uniform uniform;
  for (size_t n : {2, 3, 6, 7, 15, 32}) {
    Systems systems(16, n, 1, true, uniform);
    for (double& v : systems.a) v = v < -0.2 ? -1 : v > 0.2 ? 1 : 0.5;  // many elements of the same magnitude
    systems.solve(instructions(), rule());
    for (size_t s = 0; s < systems.count; ++s) {
      auto a = systems.one(systems.a, s), b = systems.one(systems.b, s);
      if (gauss_jordan(a, b, n, 1, rule()).solved()) {
        ASSERT_EQ(bits(systems.one(systems.x, s)), bits(b));
      }
    }
  }
}

TEST_P(EveryInstructionSet, ManySystemsFit) {
  Uniform uniform;
  Systems systems(3000, 6, 1, true, uniform);
  ASSERT_TRUE(systems.solve(instructions(), rule()).empty());
  for (size_t s = 0; s < systems.count; ++s) {
    const auto a = systems.one(systems.a, s), b = systems.one(systems.b, s), x = systems.one(systems.x, s);
    ASSERT_LT(backward_error(a.data(), b.data(), x.data(), 6, 1), 4 * kUnit) << s;
  }
}

TEST_P(EveryInstructionSet, RefusedSystemsAreNamedAndSpoilNoOther) {
  Uniform uniform;
  for (size_t n : {6, 9}) {
    Systems good(1030, n, 1, true, uniform);
    Systems spoilt = good;
    const auto at = [&](size_t s, size_t i, size_t j) -> double& {
      return spoilt.a[(i * n + j) * spoilt.count + s];
    };
    for (size_t j = 0; j < n; ++j) at(5, 3, j) = at(5, 1, j);  // two rows alike: the last pivot is lost
    for (size_t i = 0; i < n; ++i) at(700, i, 0) = 0;          // an empty column: the first is, or the last
    at(1029, 2, 2) = std::nan("");
    spoilt.b[8] = HUGE_VAL;  // system 8, first equation
    good.solve(instructions(), rule());
    const auto refusals = spoilt.solve(instructions(), rule());

    ASSERT_EQ(refusals.size(), 4u);
    EXPECT_EQ(refusals[0].system, 5u);
    EXPECT_EQ(refusals[0].pivot, n - 1);
    EXPECT_EQ(refusals[1].system, 8u);
    EXPECT_EQ(refusals[2].system, 700u);
    EXPECT_EQ(refusals[2].pivot, rule().complete ? n - 1 : 0u);
    EXPECT_EQ(refusals[3].system, 1029u);
    for (size_t s = 0; s < good.count; ++s) {
      const bool refused = s == 5 || s == 8 || s == 700 || s == 1029;
      if (refused) {
        EXPECT_TRUE(std::isnan(spoilt.one(spoilt.x, s)[0]));
      } else {
        ASSERT_EQ(bits(spoilt.one(spoilt.x, s)), bits(good.one(good.x, s))) << s;
      }
    }
  }
}

// Wherever it stands: the server looks for such numbers only when a system was refused.
TEST_P(EveryInstructionSet, ANumberThatIsNotFiniteRefusesItsSystemAlone) {
  Uniform uniform;
  for (size_t n : {6, 9}) {
    for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      for (size_t element = 0; element < n * n + n; ++element) {
        Systems systems(16, n, 1, true, uniform);
        (element < n * n ? systems.a[element * 16 + 5] : systems.b[(element - n * n) * 16 + 5]) = bad;
        const auto refusals = systems.solve(instructions(), rule());
        ASSERT_EQ(refusals.size(), 1u) << bad << " at " << element;
        EXPECT_EQ(refusals[0].system, 5u);
      }
    }
  }
}

TEST_P(EveryInstructionSet, TheThresholdReachesTheSolver) {
  Uniform uniform;
  for (size_t n : {6, 9}) {
    for (size_t small = 0; small < n; ++small) {
      Systems systems(9, n, 1, false, uniform);
      for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
          systems.a[(3 * n + i) * n + j] = i == j ? (i == small ? 1e-5 : 1.0) : 0.0;
        }
      }
      EXPECT_TRUE(systems.solve(instructions(), rule()).empty());
      const auto refusals = systems.solve(instructions(), rule(1e-4));
      const auto found = std::ranges::find(refusals, size_t{3}, &Refusal::system);
      ASSERT_NE(found, refusals.end()) << small << " of " << n;
      EXPECT_EQ(found->pivot,
                rule().complete ? n - 1 : small);  // the small one comes last when columns move too
    }
  }
}

TEST(Batch, AnEmptyBatchIsSolved) {
  EXPECT_TRUE(solve_batch({{}, {}, {}, 0, 6, 1, true}, {}).empty());
}

}  // namespace
}  // namespace animado::egesp
