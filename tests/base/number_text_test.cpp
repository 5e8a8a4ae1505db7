// src/base/number_text.hpp
#include "base/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace animado {
namespace {

TEST(NumberText, IsReadBackToTheSameBits) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, ANanHasNoSign) {
  EXPECT_EQ(number_text(std::copysign(NAN, -1)), "nan");
  EXPECT_EQ(number_text(std::copysign(NAN, 1)), "nan");
}

}  // namespace
}  // namespace animado
