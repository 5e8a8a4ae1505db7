// src/interexpserv/elementary.cpp: operations that have corners.
#include "interexpserv/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interexpserv/lanes.hpp"

namespace animado::interexpserv {
namespace {

TEST(Elementary, ModuloHasTheSignOfTheDivisorAndNoRounding) {
  EXPECT_EQ(floored_modulo(7, 3), 1);
  EXPECT_EQ(floored_modulo(-7, 3), 2);
  EXPECT_EQ(floored_modulo(7, -3), -2);
  EXPECT_EQ(floored_modulo(-7, -3), -1);
  EXPECT_EQ(floored_modulo(1e16, 3), 1);  // a - b floor(a/b) in doubles would say 0 or 2
  EXPECT_EQ(floored_modulo(5, INFINITY), 5);
  EXPECT_TRUE(std::isnan(floored_modulo(5, 0)));
}

TEST(Elementary, ZeroKeepsItsSign) {
  EXPECT_TRUE(std::signbit(value_of(Op::sign, -0.0, 0, 0)));
  EXPECT_TRUE(std::signbit(value_of(Op::negate, 0.0, 0, 0)));
}

}  // namespace
}  // namespace animado::interexpserv
