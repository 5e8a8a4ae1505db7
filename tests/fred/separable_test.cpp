// src/fred/separable.cpp: which systems a symplectic method may move, and the reason of the others.
#include "fred/separable.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "fred/equations.hpp"

namespace animado::fred {
namespace {

using Texts = std::vector<std::string>;

std::vector<bool> positions(const Texts& texts) {
  return positions_of(Equations(texts, {{"k", 1}}));
}

TEST(Separable, PositionsMoveByMomentaAndMomentaByPositions) {
  EXPECT_EQ(positions({"x' = v", "v' = -k*x"}), (std::vector{true, false}));
  EXPECT_EQ(positions({"x' = p/k", "y' = q/k", "p' = -x*y + cos(t)", "q' = -x - y^2"}),
            (std::vector{true, true, false, false}));
  EXPECT_EQ(positions({"a' = 1", "x' = v", "v' = -x"}), (std::vector{true, true, false}));
}

TEST(Separable, OthersAreRefused) {
  for (const Texts& texts :
       {Texts{"x' = v", "v' = -x - 0.1*v"}, Texts{"x' = v", "v' = -w", "w' = x"}, Texts{"x' = x"}}) {
    try {
      positions(texts);
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::refused);
      EXPECT_NE(error.message().find("separable"), std::string::npos);
      EXPECT_FALSE(error.remedy().empty());
    }
  }
}

}  // namespace
}  // namespace animado::fred
