// src/interexpserv/lane_*.hpp: the largest errors that docs/expressions.md states, and the same bits alone
// and in every lane. The reference is the C library's long double: 64 bits, right to 3 units in the last of
// them (the library's manual), which makes an error uncertain by 3/2048 of a unit of a double.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "interexpserv/elementary.hpp"
#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

using Reference = long double;
static_assert(std::numeric_limits<Reference>::digits == 64);
constexpr double kReferenceError = 3.0 / 2048;
constexpr size_t kArguments = 40'000;  // of each kind

// From the page: "| `sin`, `cos` | 0.8 |".
std::map<std::string, double> stated_errors() {
  std::ifstream file(ANIMADO_SOURCE_DIR "/docs/expressions.md");
  std::map<std::string, double> errors;
  bool here = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "| function | error |") here = true;
    const size_t bar = line.find(" | ");
    if (!here || bar == std::string::npos) continue;
    const double error = std::strtod(line.c_str() + bar + 3, nullptr);
    for (size_t open = line.find('`'); open < bar; open = line.find('`', open + 1)) {
      const size_t close = line.find('`', open + 1);
      errors[line.substr(open + 1, close - open - 1)] = error;
      open = close;
    }
  }
  return errors;
}

// In units in the last place of the number that is meant. Beyond the largest number all are alike.
double error_of(double found, Reference exact) {
  if (std::isnan(found) || std::isnan(exact)) return std::isnan(found) == std::isnan(exact) ? 0 : INFINITY;
  const auto kept = [](Reference x) { return std::clamp(x, -0x1p1024L, 0x1p1024L); };
  const int exponent = std::clamp(std::ilogb(kept(exact)), DBL_MIN_EXP - 1, DBL_MAX_EXP - 1);
  return static_cast<double>(std::abs(kept(found) - kept(exact)) / std::ldexp(1.0L, exponent - 52));
}

struct Interval {
  double low, high;
};
struct Measured {
  std::string name, text;  // as on the page; the call, of x and y
  Op op;
  std::function<Reference(Reference, Reference)> exact;
  Interval x;
  std::vector<double> corners = {};  // where one way to compute it gives place to another
  Interval y = {0, 1};

  friend void PrintTo(const Measured& m, std::ostream* out) {
    *out << m.text << " for x in " << m.x.low << " … " << m.x.high;
  }
};

class Accuracy : public testing::TestWithParam<Measured> {
 protected:
  // Even ones, in an interval with 0 those of any size, and the neighbours of corners.
  std::vector<double> arguments(Interval in, const std::vector<double>& corners = {}) {
    std::uniform_real_distribution<double> even(in.low, in.high);
    std::vector<double> all;
    for (size_t i = 0; i < kArguments; ++i) all.push_back(even(random_));
    for (size_t i = 0; i < kArguments; ++i) all.push_back(in.low <= 0 ? of_any_size(in) : even(random_));
    for (const double corner : corners) {
      for (int64_t ulps = -20; ulps <= 20; ++ulps) {
        all.push_back(std::bit_cast<double>(std::bit_cast<int64_t>(corner) + ulps));
      }
    }
    return all;
  }

  double of_any_size(Interval in) {
    for (;;) {
      const double x = std::bit_cast<double>(random_());
      if (x >= in.low && x <= in.high) return x;
    }
  }

  struct Pairs {
    std::vector<double> x, y;
  };
  Pairs pairs() {
    const Measured& m = GetParam();
    Pairs all = {arguments(m.x, m.corners), arguments(m.y)};
    all.y.resize(all.x.size(), m.y.high);
    for (const double special :
         {0.0, -0.0, double{INFINITY}, -double{INFINITY}, double{NAN}, 5e-324, DBL_MAX}) {
      for (const double other : {0.0, -0.0, double{INFINITY}, -double{INFINITY}, double{NAN}, 1.0, -3.0}) {
        all.x.insert(all.x.end(), {special, other});
        all.y.insert(all.y.end(), {other, special});
      }
    }
    return all;
  }

  std::mt19937_64 random_{20'031};
};

TEST_P(Accuracy, IsAsThePageSays) {
  static const std::map<std::string, double> stated = stated_errors();
  const Measured& m = GetParam();
  ASSERT_TRUE(stated.contains(m.name));
  const auto [x, y] = pairs();
  double worst = 0, worst_x = 0, worst_y = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const double error = error_of(value_of(m.op, x[i], y[i], x[i]), m.exact(x[i], y[i]));
    if (error > worst) worst = error, worst_x = x[i], worst_y = y[i];
  }
  EXPECT_LE(worst, stated.at(m.name) + kReferenceError) << worst_x << " " << worst_y;
  RecordProperty("units", std::to_string(worst));
}

TEST_P(Accuracy, IsTheSameInEveryLane) {
  MapScope scope;
  scope.input("x", Type::scalar).input("y", Type::scalar);
  const Program program = compile(GetParam().text, scope);
  const auto [x, y] = pairs();
  const std::vector<Lanes> rows = {{x.data()}, {y.data()}};
  std::vector<double> alone(x.size()), lanes(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const std::array<double, 2> inputs = {x[i], y[i]};
    program.evaluate(inputs.data(), &alone[i]);
  }
  const std::array<double*, 1> out = {lanes.data()};
  for (int set = 0; set <= static_cast<int>(best_instruction_set()); ++set) {
    program.evaluate_batch(std::span(rows).first(program.input_count()), x.size(), out,
                           static_cast<InstructionSet>(set));
    for (size_t i = 0; i < x.size(); ++i) {
      const bool same = std::bit_cast<uint64_t>(alone[i]) == std::bit_cast<uint64_t>(lanes[i]);
      ASSERT_TRUE(same || (std::isnan(alone[i]) && std::isnan(lanes[i])))
          << x[i] << " " << y[i] << ": " << alone[i] << " and " << lanes[i] << " in instruction set " << set;
    }
  }
}

#define OF_X(function) [](Reference x, Reference) { return function(x); }
#define OF_X_Y(function) [](Reference x, Reference y) { return function(x, y); }

const double kQuarter = std::numbers::pi / 2;
const std::vector<double> kTurns = {kQuarter, 11 * kQuarter, 355, 1e5, 1e22, 6381956970095103 * 0x1p797};
std::vector<double> turns_and(double worst) {
  std::vector<double> all = kTurns;
  all.push_back(worst);
  return all;
}

// The hexadecimal corners are the worst that a search among millions of arguments found.
const Measured kMeasured[] = {
    {"sin", "sin(x)", Op::sine, OF_X(sinl), {-100, 100}, turns_and(0x1.4606bfd4175ecp+14)},
    {"cos", "cos(x)", Op::cosine, OF_X(cosl), {-100, 100}, turns_and(0x1.99705f7bd6e24p-1)},
    {"tan", "tan(x)", Op::tangent, OF_X(tanl), {-100, 100}, turns_and(0x1.2a742d9c2580cp+6)},
    {"asin", "asin(x)", Op::arcsine, OF_X(asinl), {-1, 1}, {0.5, 1 - 1e-15}},
    {"acos", "acos(x)", Op::arccosine, OF_X(acosl), {-1, 1}, {0.5, 1 - 1e-15}},
    {"atan",
     "atan(x)",
     Op::arctangent,
     OF_X(atanl),
     {-5, 5},
     {0.4375, 0.6875, 1.1875, 2.4375, 1e300, 0x1.4d63a0fa24568p+1}},
    {"atan2", "atan2(x, y)", Op::arctangent2, OF_X_Y(atan2l), {-3, 3}, {}, {-3, 3}},
    {"sinh", "sinh(x)", Op::sinh, OF_X(sinhl), {-711, 711}, {1, 708, 710.4758}},
    {"sinh", "sinh(x)", Op::sinh, OF_X(sinhl), {-3, 3}, {0x1.6e0231393842p+0}},
    {"cosh", "cosh(x)", Op::cosh, OF_X(coshl), {-711, 711}, {708, 710.4758}},
    {"cosh", "cosh(x)", Op::cosh, OF_X(coshl), {-3, 3}, {0x1.c6538942e5b3cp+0}},
    {"tanh", "tanh(x)", Op::tanh, OF_X(tanhl), {-2, 2}, {0.625, 1, 700, 0x1.029db6ba9e0a4p-1}},
    {"exp", "exp(x)", Op::exp, OF_X(expl), {-750, 715}, {0.34657359, 708, 709.782712893384, -745.1332191}},
    {"exp", "exp(x)", Op::exp, OF_X(expl), {-2, 2}, {-0x1.62018fa613b3p+9}},
    {"log", "log(x)", Op::log, OF_X(logl), {0, 4}, {1, 0.7071067811865476, 0x1.69ed5084510bbp+0}},
    {"log", "log(x)", Op::log, OF_X(logl), {0, DBL_MAX}},
    {"log10", "log10(x)", Op::log10, OF_X(log10l), {0, 4}, {1, 10, 1000}},
    {"cbrt", "cbrt(x)", Op::cbrt, OF_X(cbrtl), {-8, 8}, {1, 8, 1e-310, DBL_MAX}},
    {"hypot", "hypot(x, y)", Op::hypot, OF_X_Y(hypotl), {-3, 3}, {}, {-3, 3}},
    {"x^y", "x^y", Op::power, OF_X_Y(powl), {0, 100}, {1, 0.7071067811865476}, {-20, 20}},
    {"x^y", "x^y", Op::power, OF_X_Y(powl), {0, DBL_MAX}, {}, {-1.2, 1.2}},
    {"x^y", "x^y", Op::power, OF_X_Y(powl), {0.9, 1.1}, {}, {-1e4, 1e4}},
};
INSTANTIATE_TEST_SUITE_P(Functions, Accuracy, testing::ValuesIn(kMeasured));

// Where y log x is far beyond what e^x is computed for.
TEST(Powers, OverflowAndVanish) {
  struct Case {
    double x, y, power;
  };
  constexpr double tiny = 5e-324, odd = 1'000'001;
  for (const auto& [x, y, power] :
       {Case{2, 1024, INFINITY}, Case{2, -1074, tiny}, Case{2, -1076, 0}, Case{10, 1e6, INFINITY},
        Case{10, -1e6, 0}, Case{0.5, 1e300, 0}, Case{0.5, -1e300, INFINITY}, Case{1.5, DBL_MAX, INFINITY},
        Case{DBL_MAX, DBL_MAX, INFINITY}, Case{DBL_MAX, -DBL_MAX, 0}, Case{tiny, odd, 0},
        Case{tiny, -odd, INFINITY}, Case{-3, odd, -INFINITY}, Case{-3, odd + 1, INFINITY},
        Case{-3, -odd, -0.0}}) {
    const double found = value_of(Op::power, x, y, x);
    EXPECT_EQ(std::bit_cast<uint64_t>(found), std::bit_cast<uint64_t>(power))
        << x << "^" << y << " = " << found;
  }
}

}  // namespace
}  // namespace animado::interexpserv
