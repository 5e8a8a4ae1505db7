// src/egesp/server.cpp and its parts: accuracy on request, least squares, sparse systems and their handles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../rpc/fake_call.hpp"
#include "egesp/protocol.hpp"
#include "egesp/server.hpp"
#include "matrices.hpp"

namespace animado::egesp {
namespace {

using rpc::ask;
using rpc::FakeCall;
using rpc::refusal;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class EgespLarge : public testing::Test {
 protected:
  EgespLarge() : service_("egesp") {
    rpc::NoSuite none;
    fill_table(service_, none);
  }
  rpc::Service service_;
};

Array vector(std::vector<double> values) {
  const auto count = static_cast<int64_t>(values.size());
  return Array::inlined({count}, std::move(values));
}

// (2 1; 1 3) x = (3; 5): x = (0.8, 1.4)
SparseSystem two_equations() {
  return {Format::triplets, 2, vector({0, 0, 1, 1}), vector({0, 1, 0, 1}), vector({2, 1, 1, 3})};
}

TEST_F(EgespLarge, TellsOfADenseSystemWhatItIsAsked) {
  Solve::Request request;
  request.matrices = Array::inlined({2, 2, 2}, {2, 0, 0, 4, 1, 0, 0, 1e-3});
  request.right_sides = Array::inlined({2, 2}, {2, 8, 1, 1});
  EXPECT_FALSE(ask<Solve>(service_, request).accuracy.has_value());

  request.residual = true;
  auto accuracy = ask<Solve>(service_, request).accuracy.value();
  EXPECT_THAT(accuracy.backward_errors, SizeIs(2));
  EXPECT_LT(accuracy.backward_errors[1], 1e-15);
  EXPECT_THAT(accuracy.reciprocal_conditions, IsEmpty());

  request.condition = true;
  accuracy = ask<Solve>(service_, request).accuracy.value();
  EXPECT_THAT(accuracy.reciprocal_conditions, ElementsAre(0.5, 1e-3));
  EXPECT_EQ(accuracy.warning, "");
}

TEST_F(EgespLarge, WarnsOfAnIllConditionedSystemAndSolvesIt) {
  Solve::Request request;
  request.matrices = Array::inlined({2, 2, 2}, {1, 0, 0, 1, 1, 0, 0, 1e-20});
  request.right_sides = Array::inlined({2, 2}, {1, 1, 1, 1});
  request.threshold = 1e-30;
  request.condition = true;
  const auto reply = ask<Solve>(service_, request);
  EXPECT_THAT(reply.solutions.values, ElementsAre(1, 1, 1, 1e20));
  EXPECT_THAT(reply.accuracy->warning, HasSubstr("system 1 of 2 is ill-conditioned: 1/κ is about 1e-20"));
}

// Without refinement the growth of Wilkinson's matrix leaves an error of about 1e-8.
TEST_F(EgespLarge, RefinesInBothLayouts) {
  Uniform uniform;
  constexpr int64_t n = 30;
  const auto a = wilkinson(n), b = random_numbers(uniform, n);
  for (const Layout layout : {Layout::systems, Layout::lanes}) {
    Solve::Request request;
    request.matrices = Array::inlined({n, n, 1}, a);
    request.right_sides = Array::inlined({n, 1}, b);
    if (layout == Layout::systems) request.matrices.shape = {1, n, n}, request.right_sides.shape = {1, n};
    request.layout = layout;
    request.refine = true;
    const auto reply = ask<Solve>(service_, request);
    EXPECT_LT(reply.accuracy->backward_errors.at(0), 1e-15);
    EXPECT_LT(backward_error(a.data(), b.data(), reply.solutions.values.data(), n, 1), 1e-15);
  }
}

TEST_F(EgespLarge, ExaminedSystemsAreRefusedAsOthers) {
  Solve::Request request;
  request.matrices = Array::inlined({2, 2, 2}, {1, 0, 0, 1, 1, 2, 2, 4});
  request.right_sides = Array::inlined({2, 2}, {1, 1, 1, 1});
  request.condition = true;
  const Error error = refusal<Solve>(service_, request);
  EXPECT_EQ(error.code(), Code::singular);
  EXPECT_THAT(error.message(), HasSubstr("system 1 of 2 is singular: pivot 1 of size 2"));
  request.matrices.values[0] = std::nan("");
  EXPECT_EQ(refusal<Solve>(service_, request).code(), Code::not_finite);
}

TEST_F(EgespLarge, LeastSquaresTellTheRank) {
  LeastSquares::Request request;
  request.matrix = Array::inlined({2, 3}, {1, 2, 3, 2, 4, 6});
  request.right_sides = vector({14, 28});
  request.minimum_norm = true;
  auto reply = ask<LeastSquares>(service_, request);
  EXPECT_EQ(reply.rank, 1);
  EXPECT_EQ(reply.null_space, 2);
  EXPECT_THAT(reply.solutions.shape, ElementsAre(3));
  for (size_t j = 0; j < 3; ++j) EXPECT_NEAR(reply.solutions.values[j], static_cast<double>(j + 1), 1e-14);
  EXPECT_NEAR(reply.residual_norms.at(0), 0, 1e-13);

  request.right_sides = Array::inlined({2, 2}, {14, 1, 28, 0});
  reply = ask<LeastSquares>(service_, request);
  EXPECT_THAT(reply.solutions.shape, ElementsAre(3, 2));
  EXPECT_NEAR(reply.residual_norms.at(1), std::sqrt(0.8), 1e-14);
}

TEST_F(EgespLarge, LeastSquaresRefuseWhatDoesNotFit) {
  LeastSquares::Request request;
  const auto code = [&](std::vector<int64_t> matrix, std::vector<int64_t> sides, double first = 1,
                        double threshold = 0) {
    request.matrix = Array::inlined(std::move(matrix), {first, 2, 3, 4});
    request.right_sides = Array::inlined(std::move(sides), {1, 1});
    request.threshold = threshold;
    return refusal<LeastSquares>(service_, request).code();
  };
  EXPECT_EQ(code({4}, {2}), Code::bad_shape);
  EXPECT_EQ(code({2, 2}, {3}), Code::bad_shape);
  EXPECT_EQ(code({0, 2}, {0}), Code::bad_shape);
  EXPECT_EQ(code({1 << 20, 1 << 20}, {1 << 20}), Code::limit);
  EXPECT_EQ(code({2, 2}, {2}, HUGE_VAL), Code::not_finite);
  EXPECT_EQ(code({2, 2}, {2}, 1, 1), Code::bad_params);
}

TEST_F(EgespLarge, SolvesASparseSystemAtOnce) {
  SparseSolve::Request request;
  request.matrix = two_equations();
  request.right_sides = vector({3, 5});
  request.residual = request.condition = request.refine = true;
  const auto reply = ask<SparseSolve>(service_, request);
  EXPECT_NEAR(reply.solutions.values.at(0), 0.8, 1e-15);
  EXPECT_NEAR(reply.solutions.values.at(1), 1.4, 1e-15);
  EXPECT_EQ(reply.facts.entries, 4);
  EXPECT_LT(reply.accuracy->backward_errors.at(0), 1e-16);
  EXPECT_NEAR(reply.accuracy->reciprocal_conditions.at(0), 5.0 / 16, 1e-15);  // ‖A‖₁ = 4, ‖A⁻¹‖₁ = 4/5
}

TEST_F(EgespLarge, PreparedSparseSystemsAreSolvedAndFactoredAnew) {
  FakeCall call;
  const int64_t handle = ask<SparsePrepare>(service_, {two_equations(), {}}, call).handle;
  SparseSolvePrepared::Request request;
  request.handle = handle;
  request.right_sides = Array::inlined({2, 2}, {2, 3, 1, 5});
  const auto first = ask<SparseSolvePrepared>(service_, request, call).solutions.values;
  EXPECT_NEAR(first[0], 1, 1e-15);
  EXPECT_NEAR(first[3], 1.4, 1e-15);

  EXPECT_EQ(ask<SparseRefactor>(service_, {handle, vector({2, 0, 0, 4})}, call).facts.entries, 4);
  EXPECT_THAT(ask<SparseSolvePrepared>(service_, request, call).solutions.values,
              ElementsAre(1, 1.5, 0.25, 1.25));
  EXPECT_EQ(refusal<SparseRefactor>(service_, {handle, vector({1, 2})}).code(), Code::bad_shape);
  EXPECT_EQ(refusal<SparseRefactor>(service_, {handle, vector({1, 2, 2, 4})}).code(), Code::singular);

  ask<Release>(service_, {handle}, call);
  EXPECT_EQ(refusal<SparseSolvePrepared>(service_, request).code(), Code::unknown_handle);
}

TEST_F(EgespLarge, HandlesEndWithTheirConnection) {
  FakeCall call;
  const int64_t handle = ask<SparsePrepare>(service_, {two_equations(), {}}, call).handle;
  service_.on_disconnect(call.connection());
  EXPECT_EQ(refusal<SparseRefactor>(service_, {handle, vector({2, 0, 0, 4})}).code(), Code::unknown_handle);
}

TEST_F(EgespLarge, SparseSystemsWriteIntoSharedArrays) {
  FakeCall call;
  call.shared["rows"] = {0, 0, 1, 1};
  call.shared["numbers"] = {2, 1, 1, 3, 3, 5};
  call.shared["x"] = {7, 7};
  SparseSolve::Request request;
  request.matrix = two_equations();
  request.matrix.rows = Array::named("rows", {4});
  request.matrix.values = Array::named("numbers", {4});
  request.right_sides = Array::named("numbers", {2}, 4);
  request.out = Array::named("x", {2});
  EXPECT_EQ(ask<SparseSolve>(service_, request, call).solutions.shared, "x");
  EXPECT_NEAR(call.shared["x"][1], 1.4, 1e-15);
}

TEST_F(EgespLarge, SparseSystemsRefuseWhatDoesNotFit) {
  SparseSolve::Request good;
  good.matrix = two_equations();
  good.right_sides = vector({3, 5});
  const auto refused = [&](const auto& spoil) {
    auto request = good;
    spoil(request);
    return refusal<SparseSolve>(service_, request);
  };
  EXPECT_EQ(refused([](auto& r) { r.matrix.rows.values[2] = 2; }).where(), "rows[2]");
  EXPECT_EQ(refused([](auto& r) { r.matrix.values.values[3] = NAN; }).where(), "matrix.values[3]");
  EXPECT_EQ(refused([](auto& r) { r.right_sides.values[1] = NAN; }).code(), Code::not_finite);
  EXPECT_EQ(refused([](auto& r) { r.right_sides = vector({1, 2, 3}); }).code(), Code::bad_shape);
  EXPECT_EQ(refused([](auto& r) { r.matrix.size = 0; }).code(), Code::bad_shape);
  EXPECT_EQ(refused([](auto& r) { r.matrix.size = int64_t{1} << 50; }).code(), Code::limit);
  EXPECT_EQ(refused([](auto& r) { r.options.threshold = 0; }).code(), Code::bad_params);
  EXPECT_EQ(refused([](auto& r) { r.matrix.values = vector({1, 2, 2, 4}); }).code(), Code::singular);
  EXPECT_EQ(refused([](auto& r) {
              r.matrix.values.values[0] = r.matrix.values.values[3] = 1e-300,
              r.matrix.values.values[1] = r.matrix.values.values[2] = 0, r.right_sides.values[0] = 1e300;
            }).code(),
            Code::not_finite);
}

}  // namespace
}  // namespace animado::egesp
