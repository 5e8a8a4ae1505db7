// src/egesp/server.prepared.cpp: what a connection prepares, and what becomes of a system without a solution.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../rpc/fake_call.hpp"
#include "egesp/protocol.hpp"
#include "egesp/server.hpp"

namespace animado::egesp {
namespace {

using rpc::ask;
using rpc::FakeCall;
using rpc::refusal;
using testing::ElementsAre;

class PreparedMessages : public testing::Test {
 protected:
  PreparedMessages() : service_("egesp") { fill_table(service_, none_); }

  int64_t prepare(Array matrices) {
    Prepare::Request request;
    request.matrices = std::move(matrices);
    return ask<Prepare>(service_, request).handle;
  }
  static SolvePrepared::Request sides(int64_t handle, Array right_sides) {
    SolvePrepared::Request request;
    request.handle = handle;
    request.right_sides = std::move(right_sides);
    return request;
  }
  std::vector<double> solve(int64_t handle, Array right_sides) {
    return ask<SolvePrepared>(service_, sides(handle, std::move(right_sides))).solutions.values;
  }

  rpc::NoSuite none_;
  rpc::Service service_;
};

const Array kTwo = Array::inlined({2, 2, 2}, {1, 0, 0, 2, 4, 0, 0, 8});

TEST_F(PreparedMessages, SolveEveryShapeOfTheProtocol) {
  const int64_t two = prepare(kTwo), one = prepare(Array::inlined({2, 2}, {2, 0, 0, 4}));
  EXPECT_THAT(solve(two, Array::inlined({2, 2}, {3, 4, 4, 8})), ElementsAre(3, 2, 1, 1));
  EXPECT_THAT(solve(two, Array::inlined({2, 2, 1}, {3, 4, 4, 8})), ElementsAre(3, 2, 1, 1));
  EXPECT_THAT(solve(one, Array::inlined({2}, {2, 8})), ElementsAre(1, 2));
  EXPECT_THAT(solve(one, Array::inlined({2, 2}, {2, 4, 8, 16})), ElementsAre(1, 2, 2, 4));
  SolvePrepared::Request request = sides(two, Array::inlined({2, 2}, {3, 4, 4, 8}));
  request.layout = Layout::lanes;
  EXPECT_THAT(ask<SolvePrepared>(service_, request).solutions.values, ElementsAre(3, 1, 2, 1));
  request.right_sides = Array::inlined({2, 3}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(refusal<SolvePrepared>(service_, request).code(), Code::bad_shape);
}

TEST_F(PreparedMessages, RefactorKeepsTheHandle) {
  const int64_t handle = prepare(kTwo);
  Refactor::Request request;
  request.handle = handle;
  request.matrices = Array::inlined({2, 2, 2}, {2, 0, 0, 2, 2, 0, 0, 2});
  ask<Refactor>(service_, request);
  EXPECT_THAT(solve(handle, Array::inlined({2, 2}, {2, 4, 6, 8})), ElementsAre(1, 2, 3, 4));
  request.matrices = Array::inlined({1, 2, 2}, {2, 0, 0, 2});
  EXPECT_EQ(refusal<Refactor>(service_, request).code(), Code::bad_shape);
  EXPECT_THAT(solve(handle, Array::inlined({2, 2}, {2, 4, 6, 8})), ElementsAre(1, 2, 3, 4));
  request.matrices = Array::inlined({2, 2, 2}, {1, 2, 2, 4, 2, 0, 0, 2});
  EXPECT_EQ(refusal<Refactor>(service_, request).code(), Code::singular);
  EXPECT_EQ(refusal<SolvePrepared>(service_, sides(handle, kTwo)).code(), Code::unknown_handle);
}

TEST_F(PreparedMessages, AHandleEndsWithItsReleaseAndWithItsConnection) {
  const Array b = Array::inlined({2, 2}, {3, 4, 4, 8});
  const int64_t first = prepare(kTwo), second = prepare(kTwo);
  ask<Release>(service_, {first});
  EXPECT_EQ(refusal<SolvePrepared>(service_, sides(first, b)).code(), Code::unknown_handle);
  EXPECT_THAT(solve(second, b), ElementsAre(3, 2, 1, 1));
  service_.on_disconnect(FakeCall().connection());
  EXPECT_EQ(refusal<SolvePrepared>(service_, sides(second, b)).code(), Code::unknown_handle);
}

TEST_F(PreparedMessages, ASingularSystemIsAnErrorOrReported) {
  Prepare::Request request;
  request.matrices = Array::inlined({2, 2, 2}, {1, 2, 2, 4, 2, 0, 0, 2});
  EXPECT_EQ(refusal<Prepare>(service_, request).code(), Code::singular);
  request.on_singular = OnSingular::report;
  const auto prepared = ask<Prepare>(service_, request);
  ASSERT_EQ(prepared.refused.size(), 1u);
  EXPECT_EQ(prepared.refused[0].system, 0);
  EXPECT_EQ(prepared.refused[0].pivot, 1);

  SolvePrepared::Request solve = sides(prepared.handle, Array::inlined({2, 2}, {1, 1, 2, 4}));
  EXPECT_EQ(refusal<SolvePrepared>(service_, solve).code(), Code::singular);
  solve.on_singular = OnSingular::report;
  const auto reply = ask<SolvePrepared>(service_, solve);
  ASSERT_EQ(reply.refused.size(), 1u);
  EXPECT_TRUE(std::isnan(reply.solutions.values[0]) && std::isnan(reply.solutions.values[1]));
  EXPECT_EQ(reply.solutions.values[2], 1);
  EXPECT_EQ(reply.solutions.values[3], 2);
}

TEST_F(PreparedMessages, SolveReportsOnRequestWithoutSpoilingTheOthers) {
  Solve::Request request;
  request.matrices = Array::inlined({3, 2, 2}, {1, 0, 0, 1, 1, 2, 2, 4, 2, 0, 0, 2});
  request.right_sides = Array::inlined({3, 2}, {5, 6, 1, 1, 2, HUGE_VAL});
  request.on_singular = OnSingular::report;
  const auto reply = ask<Solve>(service_, request);
  ASSERT_EQ(reply.refused.size(), 2u);
  EXPECT_EQ(reply.refused[0].system, 1);
  EXPECT_EQ(reply.refused[0].pivot, 1);
  EXPECT_EQ(reply.refused[1].system, 2);
  EXPECT_EQ(reply.refused[1].pivot, 2);
  EXPECT_EQ(reply.solutions.values[0], 5);
  EXPECT_EQ(reply.solutions.values[1], 6);
  for (size_t e = 2; e < 6; ++e) EXPECT_TRUE(std::isnan(reply.solutions.values[e])) << e;
}

}  // namespace
}  // namespace animado::egesp
