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
    static struct : rpc::Suite {
      rpc::Channel& channel(std::string_view) override { throw Error(Code::unavailable, "none"); }
      rpc::SharedArrays& arrays() override { throw Error(Code::unavailable, "none"); }
    } none;
    rpc::Service filled("fred");
    fill_table(filled, none);
    return filled;
  }();
  return kService;
}

// A step of y' = −y from 1 by a caller that only knows the method's stages.
double stage_by_stage(const Methods::Method& method, double step) {
  FakeCall call;
  call.shared["k"].resize(static_cast<size_t>(method.stages));
  Stage::Request request;
  request.method = method.name;
  request.step = step;
  request.state = Array::inlined({1}, {1});
  request.derivatives = Array::named("k", {method.stages, 1});
  double y = 1;
  for (int64_t s = 0; s < method.stages; ++s) {
    call.shared["k"][static_cast<size_t>(s)] = -y;
    request.stage = s + 1;
    y = ask<Stage>(service(), request, call).state.values.at(0);
  }
  return y;
}

std::vector<Methods::Method> methods_with_stages() {
  auto methods = ask<Methods>(service(), {}).methods;
  std::erase_if(methods, [](const auto& method) { return method.nodes.empty(); });
  return methods;
}

TEST(FredServer, EveryMethodCanBeSteppedStageByStage) {
  for (const auto& method : methods_with_stages()) {
    EXPECT_NEAR(stage_by_stage(method, 0.01), std::exp(-0.01),
                std::pow(0.01, static_cast<double>(method.order + 1)) + 1e-15)
        << method.name;
  }
}

// Steps so long that the last bit of a stage is seen at their end.
TEST(FredServer, StageByStageHasTheBitsOfAnIntegration) {
  for (const auto& method : methods_with_stages()) {
    for (const double step : {0.7, 1.1, 1.3, 1.9}) {
      Integrate::Request whole;
      whole.equations = {"y' = -y"};
      whole.from = {{"y", 1}};
      whole.method = method.name;
      whole.t1 = whole.step = step;
      EXPECT_EQ(stage_by_stage(method, step), ask<Integrate>(service(), whole).state.at(0))
          << method.name << " " << step;
    }
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

struct IntegrationMistake {
  const char* name;
  std::function<void(Integrate::Request&)> make;
  Code code;
};

class WrongIntegrations : public testing::TestWithParam<IntegrationMistake> {};

INSTANTIATE_TEST_SUITE_P(
    , WrongIntegrations,
    testing::Values(
        IntegrationMistake{"no_equations", [](auto& r) { r.equations.clear(); }, Code::bad_params},
        IntegrationMistake{"unknown_method", [](auto& r) { r.method = "rk5"; }, Code::unknown_name},
        IntegrationMistake{"negative_step", [](auto& r) { r.step = -1; }, Code::bad_params},
        IntegrationMistake{"nan_step", [](auto& r) { r.step = std::nan(""); }, Code::not_finite},
        IntegrationMistake{"infinite_end", [](auto& r) { r.t1 = HUGE_VAL; }, Code::not_finite},
        IntegrationMistake{"overflowing_interval", [](auto& r) { r.t0 = -1.7e308, r.t1 = 1.7e308; },
                           Code::not_finite},
        IntegrationMistake{"nan_start", [](auto& r) { r.from[0].value = std::nan(""); }, Code::not_finite},
        IntegrationMistake{"infinite_constant", [](auto& r) { r.constants[0].value = -HUGE_VAL; },
                           Code::not_finite},
        IntegrationMistake{"endless", [](auto& r) { r.step = 1e-300; }, Code::limit},
        IntegrationMistake{"too_many_samples", [](auto& r) { r.samples = int64_t{1} << 62; }, Code::limit},
        IntegrationMistake{"negative_samples", [](auto& r) { r.samples = -1; }, Code::limit},
        IntegrationMistake{"tolerance_of_rk4", [](auto& r) { r.method = "rk4", r.tolerance = 1e-6; },
                           Code::bad_params},
        IntegrationMistake{"negative_tolerance", [](auto& r) { r.tolerance = -1e-6; }, Code::bad_params},
        IntegrationMistake{"three_tolerances",
                           [](auto& r) {
                             r.absolute_tolerance = {1, 1, 1};
                           },
                           Code::bad_params},
        IntegrationMistake{"time_outside",
                           [](auto& r) {
                             r.times = {1, 3};
                           },
                           Code::bad_params},
        IntegrationMistake{"times_out_of_order",
                           [](auto& r) {
                             r.times = {1, 0.5};
                           },
                           Code::bad_params},
        IntegrationMistake{"event_of_nothing", [](auto& r) { r.events = {{"w"}}; }, Code::unknown_name},
        IntegrationMistake{"comparison_as_event", [](auto& r) { r.events = {{"x > 1"}}; }, Code::type},
        IntegrationMistake{"strange_checkpoint", [](auto& r) { r.resume.emplace(); }, Code::bad_params},
        IntegrationMistake{"pole", [](auto& r) { r.equations[0] = "x' = 1/(t - 1)^2 * x^2"; },
                           Code::diverged},
        IntegrationMistake{"caret", [](auto& r) { r.equations[0] = "x' = v +* 2"; }, Code::syntax}),
    [](const auto& tested) { return tested.param.name; });

TEST_P(WrongIntegrations, AreRefusedWithARemedy) {
  Integrate::Request request = oscillator();
  GetParam().make(request);
  const Error error = refusal<Integrate>(service(), request);
  EXPECT_EQ(error.code(), GetParam().code) << error.what();
  EXPECT_FALSE(error.remedy().empty());
}

// A caller that owns the derivative steps by the error that it is told, and looks inside the steps: cos t at
// t = 10.
TEST(FredServer, ACallerCanStepAdaptively) {
  for (const auto& method : ask<Methods>(service(), {}).methods) {
    if (method.kind != MethodKind::explicit_adaptive) continue;
    const auto n = static_cast<size_t>(method.stages);
    std::vector<double> y = {1, 0}, k(static_cast<size_t>(2 * method.derivatives));
    const auto rate = [&](size_t s, const std::vector<double>& at) {
      k[2 * s] = at[1], k[2 * s + 1] = -at[0];
    };
    const auto derivatives = [&] { return Array::inlined({method.derivatives, 2}, k); };
    Stage::Request stage;
    Estimate::Request estimate;
    Dense::Request dense;
    stage.method = estimate.method = dense.method = method.name;
    estimate.absolute_tolerance = estimate.relative_tolerance = {1e-8};
    double t = 0, h = 0.1;
    while (t < 10) {
      stage.state = estimate.state = dense.state = Array::inlined({2}, y);
      stage.step = estimate.step = dense.step = h;
      rate(0, y);
      const auto next = [&](size_t s) {
        stage.stage = static_cast<int64_t>(s);
        stage.derivatives = derivatives();
        return ask<Stage>(service(), stage).state.values;
      };
      for (size_t s = 1; s < n; ++s) rate(s, next(s));
      const std::vector<double> end = next(n);
      rate(n, end);
      estimate.end = dense.end = Array::inlined({2}, end);
      estimate.derivatives = derivatives();
      const auto told = ask<Estimate>(service(), estimate);
      if (told.error <= 1) {
        for (size_t s = n + 1; s < static_cast<size_t>(method.derivatives); ++s) rate(s, next(s));
        dense.derivatives = derivatives();
        dense.theta = 0.3;
        EXPECT_NEAR(ask<Dense>(service(), dense).state.values[0], std::cos(t + 0.3 * h), 1e-4) << method.name;
        t += h;
        y = end;
        estimate.last_error = told.error;
      }
      h = told.next_step;
    }
    EXPECT_NEAR(y[0], std::cos(t), 2e-6) << method.name;
  }
}

// The trend of the errors is seen where the step before is told.
TEST(FredServer, EstimatesSeeAGrowingErrorComing) {
  Estimate::Request request;
  request.method = "dopri5";
  request.step = 0.1;
  request.state = request.end = Array::inlined({1}, {1});
  request.derivatives = Array::inlined({7, 1}, {1, 1, 1, 1, 1, 1, 1.001});
  request.absolute_tolerance = request.relative_tolerance = {1e-5};
  request.last_error = 1e-3;
  const auto unknown = ask<Estimate>(service(), request);
  EXPECT_LT(unknown.error, 1);
  EXPECT_GT(unknown.error, 0.01);
  request.last_step = 0.1;
  EXPECT_LT(ask<Estimate>(service(), request).next_step, 0.7 * unknown.next_step);
}

// bs23's estimate is h Σ e[j] k[j], here of one derivative only.
Estimate::Request bs23_step(std::vector<int64_t> shape, const std::vector<double>& rates) {
  Estimate::Request request;
  request.method = "bs23";
  request.step = 0.1;
  request.state = request.end = Array::inlined(shape, std::vector<double>(rates.size(), 1.0));
  std::vector<double> derivatives(4 * rates.size());
  std::ranges::copy(rates, derivatives.begin());
  shape.insert(shape.begin(), 4);
  request.derivatives = Array::inlined(shape, derivatives);
  request.absolute_tolerance = request.relative_tolerance = {1e-3};
  return request;
}

TEST(FredServer, EstimatesTheErrorOfTheWorstColumn) {
  const double alone = ask<Estimate>(service(), bs23_step({2}, {1, 2})).error;
  Estimate::Request three = bs23_step({2, 3}, {0.5, 1, 0, 0, 2, 0});
  EXPECT_LT(ask<Estimate>(service(), three).error, alone);
  three.columns = true;
  EXPECT_EQ(ask<Estimate>(service(), three).error, alone);
}

TEST(FredServer, AStepDoesNotGrowRightAfterARefusal) {
  Estimate::Request request = bs23_step({1}, {1e-6});
  EXPECT_GT(ask<Estimate>(service(), request).next_step, 2 * request.step);
  request.last_refused = true;
  EXPECT_EQ(ask<Estimate>(service(), request).next_step, request.step);
}

// As `integrate` does, whose control remembers no error smaller than 1e-4.
TEST(FredServer, AStepWithoutErrorDoesNotShortenTheNext) {
  Estimate::Request request = bs23_step({1}, {0});
  request.last_error = 0;
  EXPECT_GT(ask<Estimate>(service(), request).next_step, 2 * request.step);
}

TEST(FredServer, RefusesEstimatesThatMakeNoSense) {
  Estimate::Request good;
  good.method = "dopri5";
  good.step = 0.1;
  good.state = good.end = Array::inlined({1}, {1});
  good.derivatives = Array::inlined({7, 1}, std::vector<double>(7, 1.0));
  good.absolute_tolerance = good.relative_tolerance = {1e-6};
  EXPECT_NO_THROW(ask<Estimate>(service(), good));
  const auto code = [&](const std::function<void(Estimate::Request&)>& make) {
    Estimate::Request request = good;
    make(request);
    return refusal<Estimate>(service(), request).code();
  };
  EXPECT_EQ(code([](auto& r) { r.method = "rk4"; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.derivatives.shape[0] = 6; }), Code::bad_shape);  // that at the end is needed
  EXPECT_EQ(code([](auto& r) { r.end.shape = {2}; }), Code::bad_shape);
  EXPECT_EQ(code([](auto& r) { r.absolute_tolerance = {0}; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.relative_tolerance = {1e-6, 1e-6}; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.last_step = -0.1; }), Code::bad_params);
}

TEST(FredServer, IntegratesToATolerance) {
  Integrate::Request request = oscillator();
  request.tolerance = 1e-10;
  const auto reply = ask<Integrate>(service(), request);
  EXPECT_EQ(reply.stop, Stop::end);
  EXPECT_LT(reply.steps, 200);
  EXPECT_THAT(reply.samples.shape, ElementsAre(5, 3));
  for (size_t row = 0; row < 5; ++row) {
    const double t = 0.5 * static_cast<double>(row);
    EXPECT_EQ(reply.samples.values[3 * row], t);
    EXPECT_NEAR(reply.samples.values[3 * row + 1], std::cos(2 * t), 1e-7);
  }
}

TEST(FredServer, EveryMethodIntegrates) {
  for (const auto& method : ask<Methods>(service(), {}).methods) {
    Integrate::Request request = oscillator();
    request.method = method.name;
    request.step = 1e-3;
    const auto reply = ask<Integrate>(service(), request);
    EXPECT_EQ(reply.steps, 2000) << method.name;
    EXPECT_NEAR(reply.state[0], std::cos(4),
                std::max(4 * std::pow(1e-3, static_cast<double>(method.order)), 1e-11))
        << method.name;
  }
}

TEST(FredServer, TellsEventsAndWhereItStopped) {
  Integrate::Request request = oscillator();
  request.tolerance = 1e-10;
  request.method = "dop853";
  request.times = {0.25, 0.5, 1.75};
  request.events = {{"v = -2", Crossing::any, false}, {"x", Crossing::falling, true}};
  const auto reply = ask<Integrate>(service(), request);
  EXPECT_EQ(reply.stop, Stop::event);
  ASSERT_EQ(reply.events.size(), 1u);
  EXPECT_EQ(reply.events[0].event, 1);
  EXPECT_FALSE(reply.events[0].rising);
  EXPECT_NEAR(reply.t, std::acos(-1) / 4, 1e-9);
  EXPECT_THAT(reply.samples.shape, ElementsAre(2, 3)) << "what lies behind the event is not told";
}

TEST(FredServer, GoesOnFromACheckpoint) {
  Integrate::Request request = oscillator();
  request.equations[1] = "v' = -100*k*x^7";  // turns sharply: what the control remembers counts
  request.t1 = 10;
  request.tolerance = 1e-8;
  request.method = "dop853";
  const auto all = ask<Integrate>(service(), request);
  Integrate::Request rest = request;
  rest.from.clear();
  for (request.max_steps = 1; request.max_steps < 20; ++request.max_steps) {
    const auto first = ask<Integrate>(service(), request);
    EXPECT_EQ(first.stop, Stop::step_limit);
    rest.resume = first.checkpoint;
    EXPECT_EQ(ask<Integrate>(service(), rest).state, all.state) << "after " << request.max_steps;
  }
  rest.method = "dopri5";
  EXPECT_EQ(refusal<Integrate>(service(), rest).code(), Code::conflict);
}

// y₁' = −1000 (y₁ − cos t) − sin t is y₁ = cos t whatever the start: an explicit method must take a step each
// 2/1000.
TEST(FredServer, AStiffSystemTakesFewImplicitSteps) {
  Integrate::Request request;
  request.equations = {"y' = -1000*(y - cos(t)) - sin(t)"};
  request.from = {{"y", 2}};
  request.t1 = 10;
  request.tolerance = 1e-6;
  request.method = "radau5";
  const auto implicit = ask<Integrate>(service(), request);
  request.method = "dopri5";
  EXPECT_LT(20 * implicit.steps, ask<Integrate>(service(), request).steps);
  EXPECT_NEAR(implicit.state[0], std::cos(10), 1e-5);
}

TEST(FredServer, SymplecticMethodsRefuseWhatIsNotSeparable) {
  Integrate::Request request = oscillator();
  request.method = "verlet";
  request.equations[1] = "v' = -k*x - 0.1*v";
  const Error error = refusal<Integrate>(service(), request);
  EXPECT_EQ(error.code(), Code::refused);
  EXPECT_NE(error.message().find("separable"), std::string::npos) << error.message();
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
  EXPECT_EQ(code([](auto& r) { r.method = "verlet"; }), Code::bad_params);
  EXPECT_EQ(code([](auto& r) { r.stage = 3; }), Code::bad_shape);  // only two derivatives
  EXPECT_EQ(code([](auto& r) { r.step = HUGE_VAL; }), Code::not_finite);
  EXPECT_EQ(code([](auto& r) { r.method = "gil"; }), Code::unknown_name);
  EXPECT_EQ(code([](auto& r) { r.state.shape = {-2}; }), Code::limit);
  EXPECT_EQ(code([](auto& r) { r.state.shape = {int64_t{1} << 40, int64_t{1} << 40}; }), Code::limit);
  EXPECT_EQ(code([](auto& r) { r.derivatives.shape = {4}; }), Code::bad_shape);
}

}  // namespace
}  // namespace animado::fred
