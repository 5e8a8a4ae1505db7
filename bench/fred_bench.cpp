// FRED beside Boost.odeint, GSL and SUNDIALS, all of them linked here and called as libraries.
//
// Fixed: the same tableau, the same steps, as many evaluations (checked). WorkPrecision: the time to a global
// error of 1e-6 and of 1e-10 (Arenstorf 1e-8, where rounding leaves no more), each solver with the largest
// tolerance of a common grid that reaches it; `error` and `evaluations` tell what came of it. Of ours the
// free tops lie in lanes, and go in groups where steps are fixed; of the others they lie top after top.
#include <benchmark/benchmark.h>
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <boost/numeric/odeint.hpp>

#include "differential_equations.hpp"
#include "fred/ensemble.hpp"
#include "fred/integrate.hpp"
#include "fred/methods.hpp"

namespace animado::bench {
namespace {

namespace odeint = boost::numeric::odeint;

int64_t evaluations = 0;  // of the run that goes on

template <class P>
typename P::State ours(const P& problem, const char* method, double tolerance, int64_t equal_steps = 0) {
  const auto rate = [&](double, std::span<const double> y, std::span<double> out) {
    ++evaluations;
    problem(y.data(), out.data());
  };
  auto y = P::start();
  const fred::Problem posed{rate, 0, {y.begin(), y.end()}, {}, {}};
  const auto stepper =
      equal_steps > 0
          ? fred::equal_stepper(fred::method_named(method), posed, P::kEnd / static_cast<double>(equal_steps))
          : fred::adaptive_stepper(fred::method_named(method), posed,
                                   {fred::Tolerance({tolerance}, {tolerance}, y.size()), 0});
  fred::Goal goal;
  goal.t1 = P::kEnd;
  fred::integrate(*stepper, goal);
  std::ranges::copy(stepper->y(), y.begin());
  return y;
}

template <class P>
auto for_odeint(const P& problem) {
  return [&problem](const typename P::State& y, typename P::State& rate, double) {
    ++evaluations;
    problem(y.data(), rate.data());
  };
}

constexpr double kFirstStep = 1e-4;  // of those that do not find it by themselves

template <class Stepper, class P>
typename P::State by_odeint(const P& problem, double tolerance) {
  auto y = P::start();
  odeint::integrate_adaptive(odeint::make_controlled<Stepper>(tolerance, tolerance), for_odeint(problem), y,
                             0.0, P::kEnd, kFirstStep);
  return y;
}

template <class P>
typename P::State by_bulirsch_stoer(const P& problem, double tolerance) {
  auto y = P::start();
  odeint::bulirsch_stoer<typename P::State> stepper(tolerance, tolerance);
  odeint::integrate_adaptive(stepper, for_odeint(problem), y, 0.0, P::kEnd, kFirstStep);
  return y;
}

template <class P>
typename P::State by_gsl(const P& problem, double tolerance) {
  auto y = P::start();
  const auto f = [](double, const double* at, double* rate, void* p) {
    ++evaluations;
    (*static_cast<const P*>(p))(at, rate);
    return int{GSL_SUCCESS};
  };
  gsl_odeiv2_system system = {f, nullptr, y.size(), const_cast<P*>(&problem)};
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, kFirstStep, tolerance, tolerance);
  double t = 0;
  gsl_odeiv2_driver_apply(driver, &t, P::kEnd, y.data());
  gsl_odeiv2_driver_free(driver);
  return y;
}

template <class P>
typename P::State by_cvode(const P& problem, double tolerance) {
  auto y = P::start();
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector state = N_VMake_Serial(static_cast<sunindextype>(y.size()), y.data(), context);
  void* cvode = CVodeCreate(CV_ADAMS, context);
  const auto f = [](realtype, N_Vector at, N_Vector rate, void* p) {
    ++evaluations;
    (*static_cast<const P*>(p))(N_VGetArrayPointer(at), N_VGetArrayPointer(rate));
    return 0;
  };
  CVodeInit(cvode, f, 0, state);
  CVodeSStolerances(cvode, tolerance, tolerance);
  CVodeSetUserData(cvode, const_cast<P*>(&problem));
  CVodeSetMaxNumSteps(cvode, 10'000'000);
  CVodeSetStopTime(cvode, P::kEnd);
  SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(state, 0, context);
  CVodeSetNonlinearSolver(cvode, solver);
  realtype t = 0;
  CVode(cvode, P::kEnd, state, &t, CV_NORMAL);
  SUNNonlinSolFree(solver);
  CVodeFree(&cvode);
  N_VDestroy(state);
  SUNContext_Free(&context);
  return y;
}

template <class State>
double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return std::isfinite(largest) ? largest : 1e300;
}

template <class P>
const typename P::State& reference() {
  static const typename P::State kReference = ours(P(), "dop853", 3e-15);
  return kReference;
}

template <class P>
using Solver = typename P::State (*)(const P&, double tolerance);

// The largest tolerance that reaches an error; the grid is a quarter of a decade wide.
struct Setting {
  double tolerance = 1e-3, error = 1;
  int64_t evaluations = 0;
};

template <class P>
Setting find_setting(Solver<P> solve, double wanted) {
  Setting setting;
  for (;; setting.tolerance *= std::pow(10, -0.25)) {
    evaluations = 0;
    setting.error = largest_difference(solve(P(), setting.tolerance), reference<P>());
    setting.evaluations = evaluations;
    if (setting.error <= wanted || setting.tolerance < 1e-15) return setting;
  }
}

template <class P>
void work_precision(benchmark::State& state, Solver<P> solve, const Setting& setting, double wanted) {
  if (setting.error > wanted) return state.SkipWithError("does not reach this error");
  state.counters["error"] = setting.error;
  state.counters["evaluations"] = static_cast<double>(setting.evaluations);
  const P problem;
  for (auto _ : state) benchmark::DoNotOptimize(solve(problem, setting.tolerance));
}

template <class P>
void add(const char* solver, Solver<P> solve) {
  for (const double wanted : {1e-6, P::kTightError}) {
    const std::string name = fmt::format("WorkPrecision/{}/{:.0e}/{}", P::kName, wanted, solver);
    // Looked for once, not at each repetition.
    auto setting = std::make_shared<std::optional<Setting>>();
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) {
      if (!*setting) *setting = find_setting<P>(solve, wanted);
      work_precision<P>(s, solve, **setting, wanted);
    })->Unit(benchmark::kMicrosecond);
  }
}

// Ours and theirs may see the problem in different layouts.
template <class Mine, class P>
void add_all() {
  using State = typename P::State;
  add<Mine>("fred_dop853", [](const Mine& p, double tolerance) { return ours(p, "dop853", tolerance); });
  add<Mine>("fred_verner87", [](const Mine& p, double tolerance) { return ours(p, "verner87", tolerance); });
  add<Mine>("fred_dopri5", [](const Mine& p, double tolerance) { return ours(p, "dopri5", tolerance); });
  add<P>("odeint_dopri5", by_odeint<odeint::runge_kutta_dopri5<State>, P>);
  add<P>("odeint_fehlberg78", by_odeint<odeint::runge_kutta_fehlberg78<State>, P>);
  add<P>("odeint_bulirsch_stoer", by_bulirsch_stoer<P>);
  add<P>("gsl_rk8pd", by_gsl<P>);
  add<P>("cvode_adams", by_cvode<P>);
}

// --- equal steps

// The tops know nothing of each other: an ensemble.
template <class P>
typename P::State ours_by_equal_steps(const P& problem, const char* name, int64_t steps) {
  if constexpr (requires { requires P::kIsEnsemble; }) {
    const fred::Method& method = fred::method_named(name);
    const double h = P::kEnd / static_cast<double>(steps);
    const auto rate = [&](double, size_t first, size_t count, const double* y, double* out) {
      evaluations += first == 0;  // of all, as it counts for odeint
      problem(y, out, count);
    };
    return fred::integrate(method, {rate, 0, P::start().size() / P::kCount, P::start()}, P::kEnd,
                           [&](const fred::Problem& group) { return fred::equal_stepper(method, group, h); })
        .y;
  } else {
    return ours(problem, name, 0, steps);
  }
}

template <class P>
constexpr int64_t kEqualSteps = P::kEnd < 5 ? 2000 : 400;

template <class Mine>
void fixed_ours(benchmark::State& state, const char* method) {
  const Mine problem;
  evaluations = 0;
  for (auto _ : state) benchmark::DoNotOptimize(ours_by_equal_steps(problem, method, kEqualSteps<Mine>));
  state.counters["evaluations"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kAvgIterations);
}

template <class Stepper, class P>
void fixed_odeint(benchmark::State& state, const char* method) {
  const P problem;
  const auto run = [&] {
    auto y = P::start();
    odeint::integrate_n_steps(Stepper(), for_odeint(problem), y, 0.0,
                              P::kEnd / static_cast<double>(kEqualSteps<P>),
                              static_cast<size_t>(kEqualSteps<P>));
    return y;
  };
  // The same work before it is timed: as many evaluations (but for the one that a method whose last stage is
  // the next first begins with), and the same result.
  evaluations = 0;
  const auto theirs = run();
  const int64_t their_evaluations = std::exchange(evaluations, 0);
  const auto mine = ours_by_equal_steps(problem, method, kEqualSteps<P>);
  if (evaluations > their_evaluations || evaluations < their_evaluations - 1)
    return state.SkipWithError("another number of evaluations");
  if (largest_difference(mine, theirs) > 1e-8) return state.SkipWithError("another result");
  evaluations = 0;
  for (auto _ : state) benchmark::DoNotOptimize(run());
  state.counters["evaluations"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kAvgIterations);
}

template <class Mine, class P>
void add_fixed() {
  const auto add_one = [](const std::string& solver, void (*measure)(benchmark::State&, const char*),
                          const char* method) {
    const std::string name = fmt::format("Fixed/{}/{}_{}", P::kName, solver, method);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) {
      measure(s, method);
    })->Unit(benchmark::kMicrosecond);
  };
  add_one("fred", fixed_ours<Mine>, "rk4");
  add_one("odeint", fixed_odeint<odeint::runge_kutta4<typename P::State>, P>, "rk4");
  add_one("fred", fixed_ours<Mine>, "dopri5");
  add_one("odeint", fixed_odeint<odeint::runge_kutta_dopri5<typename P::State>, P>, "dopri5");
}

const bool kRegistered = [] {
  gsl_set_error_handler_off();
  add_fixed<Pleiades, Pleiades>();
  add_fixed<Tops<true>, Tops<false>>();
  add_all<Arenstorf, Arenstorf>();
  add_all<Pleiades, Pleiades>();
  add_all<Tops<true>, Tops<false>>();
  return true;
}();

}  // namespace
}  // namespace animado::bench
