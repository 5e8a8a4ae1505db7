// src/interexpserv/instruction.hpp: operations that have corners.
#include "interexpserv/instruction.hpp"

#include <gtest/gtest.h>

namespace animado::interexpserv {
namespace {

TEST(Instruction, ModuloHasTheSignOfTheDivisorAndNoRounding) {
  EXPECT_EQ(floored_modulo(7, 3), 1);
  EXPECT_EQ(floored_modulo(-7, 3), 2);
  EXPECT_EQ(floored_modulo(7, -3), -2);
  EXPECT_EQ(floored_modulo(-7, -3), -1);
  EXPECT_EQ(floored_modulo(1e16, 3), 1);  // a - b floor(a/b) in doubles would say 0 or 2
  EXPECT_EQ(floored_modulo(5, INFINITY), 5);
  EXPECT_TRUE(std::isnan(floored_modulo(5, 0)));
}

TEST(Instruction, ZeroKeepsItsSign) {
  EXPECT_TRUE(std::signbit(value_of(Op::sign, -0.0, 0, 0)));
  EXPECT_TRUE(std::signbit(value_of(Op::negate, 0.0, 0, 0)));
}

TEST(Instruction, WhatStandsStillHasNoRateAtAnInfiniteSlope) {
  EXPECT_EQ(rate_of(Op::sqrt, 0, 0, 0, 0, 0, 0), 0);
  EXPECT_EQ(rate_of(Op::power, 0, 0, 0.5, 0, 0, 0), 0);
  EXPECT_EQ(rate_of(Op::power, 4, -2, 2, 1, 0, 0), -4);  // a negative base with an exponent at rest
  EXPECT_EQ(rate_of(Op::sqrt, 0, 0, 0, 1, 0, 0), INFINITY);
}

}  // namespace
}  // namespace animado::interexpserv
