// src/egesp/server.cpp: the shapes that messages may have, where results go, and what is refused with which
// remedy.
#include "egesp/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../rpc/fake_call.hpp"
#include "egesp/protocol.hpp"

namespace animado::egesp {
namespace {

using rpc::ask;
using rpc::FakeCall;
using rpc::refusal;
using testing::ElementsAre;
using testing::HasSubstr;

Invert::Request inverse_of(Array matrices) {
  Invert::Request request;
  request.matrices = std::move(matrices);
  return request;
}

const rpc::Service& service() {
  static rpc::Service kService = [] {
    rpc::NoSuite none;
    rpc::Service filled("egesp");
    fill_table(filled, none);
    return filled;
  }();
  return kService;
}

Solve::Request system_of_two() {
  Solve::Request request;
  request.matrices = Array::inlined({2, 2}, {2, 0, 0, 4});
  request.right_sides = Array::inlined({2}, {2, 8});
  return request;
}

TEST(EgespServer, SolvesEveryShapeOfTheProtocol) {
  Solve::Request request = system_of_two();
  EXPECT_THAT(ask<Solve>(service(), request).solutions.values, ElementsAre(1, 2));

  request.right_sides = Array::inlined({2, 3}, {2, 4, 6, 4, 8, 12});
  EXPECT_THAT(ask<Solve>(service(), request).solutions.values, ElementsAre(1, 2, 3, 1, 2, 3));

  request.matrices = Array::inlined({2, 2, 2}, {1, 0, 0, 2, 4, 0, 0, 8});
  request.right_sides = Array::inlined({2, 2}, {3, 4, 4, 8});
  EXPECT_THAT(ask<Solve>(service(), request).solutions.values, ElementsAre(3, 2, 1, 1));

  request.right_sides = Array::inlined({2, 2, 1}, {3, 4, 4, 8});
  const auto reply = ask<Solve>(service(), request);
  EXPECT_THAT(reply.solutions.values, ElementsAre(3, 2, 1, 1));
  EXPECT_THAT(reply.solutions.shape, ElementsAre(2, 2, 1));
}

TEST(EgespServer, SolvesInterleavedSystems) {
  Solve::Request request;
  request.layout = Layout::lanes;
  request.matrices = Array::inlined({2, 2, 3}, {1, 2, 4, 0, 0, 0, 0, 0, 0, 2, 4, 8});
  request.right_sides = Array::inlined({2, 3}, {1, 2, 4, 4, 8, 16});
  EXPECT_THAT(ask<Solve>(service(), request).solutions.values, ElementsAre(1, 1, 1, 2, 2, 2));
  request.right_sides = Array::inlined({2, 2, 3}, {1, 2, 4, 2, 4, 8, 4, 8, 16, 2, 4, 8});
  EXPECT_THAT(ask<Solve>(service(), request).solutions.values,
              ElementsAre(1, 1, 1, 2, 2, 2, 2, 2, 2, 1, 1, 1));
}

TEST(EgespServer, AnEmptyBatchHasAnEmptyAnswer) {
  Solve::Request request;
  request.matrices = Array::inlined({0, 6, 6}, {});
  request.right_sides = Array::inlined({0, 6}, {});
  EXPECT_THAT(ask<Solve>(service(), request).solutions.shape, ElementsAre(0, 6));
}

TEST(EgespServer, WritesIntoTheSharedArrayThatIsNamed) {
  FakeCall call;
  call.shared["numbers"] = {9, 2, 0, 0, 4, 2, 8};
  call.shared["x"] = {7, 7, 7};
  Solve::Request request;
  request.matrices = Array::named("numbers", {2, 2}, 1);
  request.right_sides = Array::named("numbers", {2}, 5);
  request.out = Array::named("x", {2}, 1);
  const auto reply = ask<Solve>(service(), request, call);
  EXPECT_THAT(call.shared["x"], ElementsAre(7, 1, 2));
  EXPECT_EQ(reply.solutions.shared, "x");
  EXPECT_TRUE(reply.solutions.values.empty());

  request.out = Array::named("numbers", {2}, 4);
  EXPECT_THROW(ask<Solve>(service(), request, call), Error)
      << "the result would overwrite what it is computed from";
  request.out = Array::named("x", {3});
  EXPECT_THROW(ask<Solve>(service(), request, call), Error);
}

TEST(EgespServer, InvertsAndMeasures) {
  const auto inverted =
      ask<Invert>(service(), inverse_of(Array::inlined({2, 2, 2}, {2, 0, 0, 4, 0, 1, 1, 0})));
  EXPECT_THAT(inverted.inverses.values, ElementsAre(0.5, 0, 0, 0.25, 0, 1, 1, 0));
  EXPECT_THAT(inverted.determinants, ElementsAre(8, -1));
  const auto determinants =
      ask<Determinant>(service(), {Array::inlined({2, 2, 2}, {2, 0, 0, 4, 1, 2, 2, 4})});
  EXPECT_THAT(determinants.determinants, ElementsAre(8, 0));
  EXPECT_THAT(ask<Rank>(service(), {.matrices = Array::inlined({2, 3}, {1, 2, 3, 2, 4, 6})}).ranks,
              ElementsAre(1));
}

TEST(EgespServer, ASingularSystemIsNamed) {
  Solve::Request request;
  request.matrices = Array::inlined({3, 2, 2}, {1, 0, 0, 1, 1, 2, 2, 4, 0, 0, 0, 0});
  request.right_sides = Array::inlined({3, 2}, {1, 1, 1, 1, 1, 1});
  const Error error = refusal<Solve>(service(), request);
  EXPECT_EQ(error.code(), Code::singular);
  EXPECT_THAT(error.message(), HasSubstr("system 1 of 3 is singular: pivot 1 of size 2"));
  EXPECT_THAT(error.message(), HasSubstr("1 more"));
  EXPECT_EQ(error.where(), "matrices[1]");
  EXPECT_FALSE(error.remedy().empty());
  EXPECT_EQ(refusal<Invert>(service(), inverse_of(Array::inlined({2, 2}, {1, 2, 2, 4}))).code(),
            Code::singular);
}

TEST(EgespServer, NumbersThatAreNotFiniteAreNamed) {
  for (double bad : {std::nan(""), HUGE_VAL}) {
    Solve::Request request = system_of_two();
    request.matrices.values[3] = bad;
    Error error = refusal<Solve>(service(), request);
    EXPECT_EQ(error.code(), Code::not_finite);
    EXPECT_EQ(error.where(), "matrices[3]");

    request = system_of_two();
    request.right_sides.values[0] = bad;
    error = refusal<Solve>(service(), request);
    EXPECT_EQ(error.code(), Code::not_finite);
    EXPECT_EQ(error.where(), "right_sides[0]");

    const Array bad_matrix = Array::inlined({1, 1}, {bad});
    EXPECT_EQ(refusal<Invert>(service(), inverse_of(bad_matrix)).code(), Code::not_finite);
    EXPECT_EQ(refusal<Determinant>(service(), {bad_matrix}).code(), Code::not_finite);
    EXPECT_EQ(refusal<Rank>(service(), {.matrices = bad_matrix}).code(), Code::not_finite);
  }
}

TEST(EgespServer, AnOverflowIsNotASolution) {
  Solve::Request request = system_of_two();
  request.matrices = Array::inlined({2, 2}, {1e-200, 0, 0, 1e-200});
  request.right_sides.values = {1e200, 1};
  EXPECT_EQ(refusal<Solve>(service(), request).code(), Code::not_finite);
}

struct WrongShape {
  std::vector<int64_t> matrices, right_sides;
  Layout layout;
  Code code;
};

class WrongShapes : public testing::TestWithParam<WrongShape> {};

INSTANTIATE_TEST_SUITE_P(
    , WrongShapes,
    testing::Values(WrongShape{{4}, {2}, Layout::systems, Code::bad_shape},
                    WrongShape{{2, 3}, {2}, Layout::systems, Code::bad_shape},
                    WrongShape{{2, 2}, {3}, Layout::systems, Code::bad_shape},
                    WrongShape{{2, 2}, {}, Layout::systems, Code::bad_shape},
                    WrongShape{{2, 2}, {2, 0}, Layout::systems, Code::bad_shape},
                    WrongShape{{0, 0}, {0}, Layout::systems, Code::bad_shape},
                    WrongShape{{-1, -1}, {-1}, Layout::systems, Code::bad_shape},
                    WrongShape{{5, 2, 2}, {2, 5}, Layout::systems, Code::bad_shape},
                    WrongShape{{5, 2, 2}, {5, 2}, Layout::lanes, Code::bad_shape},
                    WrongShape{{2, 2, 5}, {5, 2}, Layout::lanes, Code::bad_shape},
                    WrongShape{{1, 1, 2, 2}, {2}, Layout::systems, Code::bad_shape},
                    WrongShape{{5000, 5000}, {5000}, Layout::systems, Code::limit},
                    WrongShape{{1 << 20, 1000, 1000}, {1 << 20, 1000}, Layout::systems, Code::limit},
                    WrongShape{
                        {int64_t{1} << 40, 2, 2}, {int64_t{1} << 40, 2}, Layout::systems, Code::limit}));

TEST_P(WrongShapes, AreRefusedWithARemedy) {
  Solve::Request request;
  request.layout = GetParam().layout;
  request.matrices = Array::inlined(GetParam().matrices, {});
  request.right_sides = Array::inlined(GetParam().right_sides, {});
  const Error error = refusal<Solve>(service(), request);
  EXPECT_EQ(error.code(), GetParam().code) << error.what();
  EXPECT_FALSE(error.remedy().empty());
}

TEST(EgespServer, RefusesAThresholdThatIsNoFraction) {
  for (double threshold : {-1e-9, 1.0, 7.0, std::nan("")}) {
    Solve::Request request = system_of_two();
    request.threshold = threshold;
    EXPECT_EQ(refusal<Solve>(service(), request).code(), Code::bad_params) << threshold;
  }
}

}  // namespace
}  // namespace animado::egesp
