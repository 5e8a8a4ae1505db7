// The three formulas of the language's bench beside muParser, linked in the same binary: one evaluation at a
// time, 10,000 at once, compiling. `muparser_ratio` is how many times as long muParser takes in the same run
// Times are the
// thread's own, so that others on the machine disturb less.
#include <benchmark/benchmark.h>
#include <muParser.h>

#include <array>
#include <ctime>

#include "interexpserv/program.hpp"

namespace animado::bench {
namespace {

using namespace interexpserv;

constexpr size_t kBodies = 10'000, kCompiled = 20;

struct Formula {
  std::string_view text, muparser;
  std::vector<std::string> names;
};
const std::array<Formula, 3> kFormulas = {
    {{"-9.81*m", "-9.81*m", {"m"}},
     {"a*sin(2*t+0.5)+b*exp(-t/3)", "a*sin(2*t+0.5)+b*exp(-t/3)", {"a", "t", "b"}},
     {"sqrt(x^2+y^2+z^2) < 3 and t > 1 ? k*(x-x0) : 0",
      "sqrt(x^2+y^2+z^2) < 3 && t > 1 ? k*(x-x0) : 0",
      {"x", "y", "z", "t", "k", "x0"}}}};

MapScope scope_of(const Formula& formula) {
  MapScope scope;
  for (const std::string& name : formula.names) scope.input(name, Type::scalar);
  return scope;
}

// Each formula with a number, or a row of numbers, for each name. The first name changes.
struct Ours {
  explicit Ours(const Formula& formula) : program(compile(formula.text, scope_of(formula))) {
    for (size_t i = 0; i < program.input_count(); ++i) {
      rows.emplace_back(kBodies);
      for (size_t k = 0; k < kBodies; ++k)
        rows[i][k] = 1.1 + 0.3 * static_cast<double>(i) + 1e-4 * static_cast<double>(k);
      numbers.push_back(rows[i][0]);
      lanes.push_back({rows[i].data()});
    }
  }
  Program program;
  std::vector<std::vector<double>> rows;
  std::vector<double> numbers;
  std::vector<Lanes> lanes;
};

struct Theirs {
  Theirs(const Formula& formula, const Ours& ours) : rows(ours.rows) {
    for (size_t i = 0; i < rows.size(); ++i) numbers.push_back(rows[i][0]);
    for (size_t i = 0; i < rows.size(); ++i) {
      const std::string& name = ours.program.inputs()[i].name;
      one.DefineVar(name, &numbers[i]);
    }
    one.SetExpr(std::string(formula.muparser));
    one.Eval();
  }
  std::vector<std::vector<double>> rows;
  std::vector<double> numbers;
  mu::Parser one;
};

template <class F>
double seconds_of(F&& f) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  f();
  return now() - start;
}

// Both in turn, in short stretches, so that a noisy machine disturbs both.
template <class Our, class Their>
void compare(benchmark::State& state, size_t evaluations, Our&& ours, Their&& theirs) {
  double our_s = 0, their_s = 0;
  for (auto _ : state) {
    const double s = seconds_of(ours);
    their_s += seconds_of(theirs);
    our_s += s;
    state.SetIterationTime(s);
  }
  const double each = static_cast<double>(state.iterations()) * static_cast<double>(evaluations);
  state.counters["ns"] = 1e9 * our_s / each;
  state.counters["muparser_ns"] = 1e9 * their_s / each;
  state.counters["muparser_ratio"] = their_s / our_s;
}

void expression_alone(benchmark::State& state) {
  const Formula& formula = kFormulas[static_cast<size_t>(state.range(0))];
  Ours ours(formula);
  Theirs theirs(formula, ours);
  const auto each = [&](double* changing, auto evaluate) {
    for (size_t k = 0; k < kBodies; ++k) {
      *changing = 1.1 + 1e-4 * static_cast<double>(k);
      double value = evaluate();
      benchmark::DoNotOptimize(value);
    }
  };
  compare(
      state, kBodies,
      [&] {
        each(ours.numbers.data(), [&] {
          double value;
          ours.program.evaluate(ours.numbers.data(), &value);
          return value;
        });
      },
      [&] { each(theirs.numbers.data(), [&] { return theirs.one.Eval(); }); });
}

void expression_batch(benchmark::State& state) {
  const Formula& formula = kFormulas[static_cast<size_t>(state.range(0))];
  const auto instructions = static_cast<InstructionSet>(state.range(1));
  if (instructions > best_instruction_set()) return state.SkipWithError("not on this machine");
  Ours ours(formula);
  Theirs theirs(formula, ours);
  std::vector<double> out(kBodies), their_out(kBodies);
  const std::array<double*, 1> rows = {out.data()};
  compare(
      state, kBodies,
      [&] {
        ours.program.evaluate_batch(ours.lanes, kBodies, rows, instructions);
        benchmark::DoNotOptimize(out.data());
      },
      [&] {
        for (size_t k = 0; k < kBodies; ++k) {
          for (size_t i = 0; i < theirs.numbers.size(); ++i) theirs.numbers[i] = theirs.rows[i][k];
          their_out[k] = theirs.one.Eval();
        }
        benchmark::DoNotOptimize(their_out.data());
      });
}

void expression_compile(benchmark::State& state) {
  const Formula& formula = kFormulas[static_cast<size_t>(state.range(0))];
  const MapScope scope = scope_of(formula);
  const Ours ours(formula);
  Theirs theirs(formula, ours);
  compare(
      state, kCompiled,
      [&] {
        for (size_t k = 0; k < kCompiled; ++k) {
          benchmark::DoNotOptimize(compile(formula.text, scope).input_count());
        }
      },
      [&] {
        for (size_t k = 0; k < kCompiled; ++k) {
          theirs.one.SetExpr(std::string(formula.muparser));
          benchmark::DoNotOptimize(theirs.one.Eval());  // it compiles at the first evaluation
        }
      });
}

BENCHMARK(expression_alone)->Arg(0)->Arg(1)->Arg(2)->UseManualTime();
BENCHMARK(expression_batch)->ArgsProduct({{0, 1, 2}, {0, 1, 2}})->UseManualTime();
BENCHMARK(expression_compile)->Arg(0)->Arg(1)->Arg(2)->UseManualTime();

}  // namespace
}  // namespace animado::bench
