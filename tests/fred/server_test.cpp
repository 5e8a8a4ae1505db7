// src/fred/server.cpp: a step asked stage by stage, integration of expressions, and what is refused with
// which remedy.
#include "fred/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../rpc/fake_call.hpp"
#include "fred/protocol.hpp"

namespace animado::fred {
namespace {

using rpc::ask;
using rpc::FakeCall;
using rpc::refusal;
using testing::ElementsAre;

const rpc::Service& service() {
  static rpc::Service kService = [] {
    struct NoSuite : rpc::Suite {
      rpc::Channel& channel(std::string_view) override { throw Error(Code::unavailable, "none"); }
      rpc::SharedArrays& arrays() override { throw Error(Code::unavailable, "none"); }
    } none;
    rpc::Service filled("fred");
    fill_table(filled, none);
    return filled;
  }();
  return kService;
}

// y' = −y by a caller that only knows the nodes: one step of every method agrees with e^−h to its order.
TEST(FredServer, EveryMethodCanBeSteppedStageByStage) {
  for (const auto& method : ask<Methods>(service(), {}).methods) {
    FakeCall call;
    call.shared["k"].resize(static_cast<size_t>(method.stages));
    Stage::Request request;
    request.method = method.name;
    request.step = 0.01;
    request.state = Array::inlined({1}, {1});
    request.derivatives = Array::named("k", {method.stages, 1});
    double y = 1;
    for (int64_t s = 0; s < method.stages; ++s) {
      call.shared["k"][static_cast<size_t>(s)] = -y;
      request.stage = s + 1;
      y = ask<Stage>(service(), request, call).state.values.at(0);
    }
    EXPECT_NEAR(y, std::exp(-0.01), std::pow(0.01, static_cast<double>(method.order + 1))) << method.name;
  }
}

TEST(FredServer, AStageIsWrittenIntoTheSharedArrayThatIsNamed) {
  FakeCall call;
  call.shared["y"] = {1, 2, 3, 4};
  call.shared["k"] = std::vector<double>(16, 1.0);
  call.shared["out"] = std::vector<double>(4);
  Stage::Request request;
  request.stage = 1;
  request.step = 0.5;
  request.state = Array::named("y", {2, 2});
  request.derivatives = Array::named("k", {4, 2, 2});
  request.out = Array::named("out", {2, 2});
  EXPECT_EQ(ask<Stage>(service(), request, call).state.shared, "out");
  EXPECT_THAT(call.shared["out"], ElementsAre(1.25, 2.25, 3.25, 4.25));
  request.out = Array::named("y", {2, 2});
  EXPECT_THROW(ask<Stage>(service(), request, call), Error) << "the step could not be asked for again";
}

Integrate::Request oscillator() {
  Integrate::Request request;
  request.equations = {"x' = v", "v' = -k*x"};
  request.from = {{"v", 0}, {"x", 1}};
  request.constants = {{"k", 4}};
  request.t1 = 2;
  request.samples = 4;
  return request;
}

TEST(FredServer, IntegratesExpressions) {
  const auto reply = ask<Integrate>(service(), oscillator());
  EXPECT_THAT(reply.names, ElementsAre("x", "v"));
  EXPECT_THAT(reply.samples.shape, ElementsAre(5, 3));
  EXPECT_EQ(reply.steps, 1000);
  EXPECT_EQ(reply.evaluations, 4000);
  for (size_t row = 0; row < 5; ++row) {
    const double t = 0.5 * static_cast<double>(row);
    EXPECT_NEAR(reply.samples.values[3 * row], t, 1e-15);
    EXPECT_NEAR(reply.samples.values[3 * row + 1], std::cos(2 * t), 1e-11);
    EXPECT_NEAR(reply.samples.values[3 * row + 2], -2 * std::sin(2 * t), 2e-11);
  }
}

struct Mistake {
  const char* name;
  std::function<void(Integrate::Request&)> make;
  Code code;
};

class WrongIntegrations : public testing::TestWithParam<Mistake> {};

INSTANTIATE_TEST_SUITE_P(
    , WrongIntegrations,
    testing::Values(
        Mistake{"no_equations", [](auto& r) { r.equations.clear(); }, Code::bad_params},
        Mistake{"unknown_method", [](auto& r) { r.method = "rk5"; }, Code::unknown_name},
        Mistake{"negative_step", [](auto& r) { r.step = -1; }, Code::bad_params},
        Mistake{"nan_step", [](auto& r) { r.step = std::nan(""); }, Code::not_finite},
        Mistake{"infinite_end", [](auto& r) { r.t1 = HUGE_VAL; }, Code::not_finite},
        Mistake{"overflowing_interval", [](auto& r) { r.t0 = -1.7e308, r.t1 = 1.7e308; }, Code::not_finite},
        Mistake{"nan_start", [](auto& r) { r.from[0].value = std::nan(""); }, Code::not_finite},
        Mistake{"infinite_constant", [](auto& r) { r.constants[0].value = -HUGE_VAL; }, Code::not_finite},
        Mistake{"endless", [](auto& r) { r.step = 1e-300; }, Code::limit},
        Mistake{"too_many_samples", [](auto& r) { r.samples = int64_t{1} << 62; }, Code::limit},
        Mistake{"negative_samples", [](auto& r) { r.samples = -1; }, Code::limit},
        Mistake{"pole", [](auto& r) { r.equations[0] = "x' = 1/(t - 1)^2 * x^2"; }, Code::diverged},
        Mistake{"caret", [](auto& r) { r.equations[0] = "x' = v +* 2"; }, Code::syntax}),
    [](const auto& tested) { return tested.param.name; });

TEST_P(WrongIntegrations, AreRefusedWithARemedy) {
  Integrate::Request request = oscillator();
  GetParam().make(request);
  const Error error = refusal<Integrate>(service(), request);
  EXPECT_EQ(error.code(), GetParam().code) << error.what();
  EXPECT_FALSE(error.remedy().empty());
}

TEST(FredServer, RefusesStagesThatMakeNoSense) {
  Stage::Request good;
  good.stage = 2;
  good.step = 0.1;
  good.state = Array::inlined({2}, {1, 2});
  good.derivatives = Array::inlined({2, 2}, {1, 2, 3, 4});
  EXPECT_NO_THROW(ask<Stage>(service(), good));
  const auto code = [&](const std::function<void(Stage::Request&)>& make) {
    Stage::Request request = good;
    make(request);
    return refusal<Stage>(service(), request).code();
  };
  EXPECT_EQ(code([](auto& r) { r.stage = 0; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.stage = 5; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.stage = 3; }), Code::bad_shape);  // only two derivatives
  EXPECT_EQ(code([](auto& r) { r.step = HUGE_VAL; }), Code::not_finite);
  EXPECT_EQ(code([](auto& r) { r.method = "gil"; }), Code::unknown_name);
  EXPECT_EQ(code([](auto& r) { r.state.shape = {-2}; }), Code::limit);
  EXPECT_EQ(code([](auto& r) { r.state.shape = {int64_t{1} << 40, int64_t{1} << 40}; }), Code::limit);
  EXPECT_EQ(code([](auto& r) { r.derivatives.shape = {4}; }), Code::bad_shape);
}

}  // namespace
}  // namespace animado::fred
