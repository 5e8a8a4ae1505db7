// src/interexpserv/builder.cpp
#include "interexpserv/builder.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::interexpserv {
namespace {

TEST(Builder, ConstantsAreFolded) {
  Builder b;
  const Register sum = b.apply(Op::add, b.constant(2.0), b.constant(3.0));
  const CompiledCode code = b.finish(Operand::scalar(sum));
  EXPECT_TRUE(code.instructions.empty());
  EXPECT_EQ(code.constants, std::vector<double>{5});
}

TEST(Builder, WhatWasComputedIsNotComputedAgain) {
  Builder b;
  const Register t = b.input({"t", Type::scalar}).at[0];
  EXPECT_EQ(b.input({"t", Type::scalar}).at[0], t);
  EXPECT_EQ(b.apply(Op::sine, t), b.apply(Op::sine, t));
  EXPECT_NE(b.apply(Op::sine, t), b.apply(Op::cosine, t));
}

TEST(Builder, ZerosOfEitherSignAreTwoConstants) {
  Builder b;
  EXPECT_NE(b.constant(0.0), b.constant(-0.0));
  EXPECT_EQ(b.constant(0.0), b.constant(0.0));
}

TEST(Builder, WhatTheResultDoesNotNeedIsGone) {
  Builder b;
  const Register unused = b.input({"unused", Type::scalar}).at[0];
  const Operand v = b.input({"v", Type::vector});
  b.apply(Op::sine, unused);
  const CompiledCode code = b.finish(Operand::scalar(b.apply(Op::multiply, v.at[1], b.constant(2.0))));
  EXPECT_EQ(code.inputs, (std::vector<Input>{{"v", Type::vector}}));
  EXPECT_EQ(code.input_count, 3u);
  EXPECT_EQ(code.constants, std::vector<double>{2});
  ASSERT_EQ(code.instructions.size(), 1u);
  EXPECT_EQ(code.instructions[0].a, 2);  // constant, v.x, v.y
  EXPECT_EQ(code.result.at[0], 4);
  EXPECT_EQ(code.registers, 5u);
}

TEST(Builder, ASignGoesIntoAConstantFactorOrDivisor) {
  for (const Op op : {Op::multiply, Op::divide}) {
    Builder b;
    const Register t = b.input({"t", Type::scalar}).at[0];
    const CompiledCode code = b.finish(Operand::scalar(b.apply(op, b.apply(Op::negate, t), b.constant(3.0))));
    ASSERT_EQ(code.instructions.size(), 1u);
    EXPECT_EQ(code.instructions[0].op, op);
    EXPECT_EQ(code.constants, std::vector<double>{-3});
  }
}

TEST(Builder, AChoiceThatIsKnownIsTaken) {
  Builder b;
  const Register x = b.input({"x", Type::scalar}).at[0], y = b.input({"y", Type::scalar}).at[0];
  EXPECT_EQ(b.apply(Op::select, b.constant(1.0), x, y), x);
  EXPECT_EQ(b.apply(Op::select, b.constant(0.0), x, y), y);
}

TEST(Builder, TooManyOperationsAreRefused) {
  Builder b;
  Register r = b.input({"t", Type::scalar}).at[0];
  for (size_t i = 1; i < kMaxRegisters; ++i) r = b.apply(Op::sine, r);
  EXPECT_THROW(b.apply(Op::sine, r), Error);
}

}  // namespace
}  // namespace animado::interexpserv
