#include "fred/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "base/error.hpp"
#include "base/fold.hpp"
#include "base/nearest_name.hpp"
#include "fred/adaptive_steps.hpp"
#include "fred/equal_steps.hpp"
#include "fred/radau.hpp"
#include "fred/runge_kutta.hpp"
#include "fred/symplectic.hpp"

namespace animado::fred {
namespace {

constexpr double kFixedStepTolerance = 1e-13;  // where Newton iteration stops when no tolerance is given

std::vector<Method> all_methods() {
  std::vector<Method> all;
  for (const Tableau& t : tableaus()) {
    const auto kind = t.is_adaptive() ? MethodKind::explicit_adaptive : MethodKind::explicit_fixed;
    all.push_back(
        {t.name, t.reference, kind, t.order, static_cast<int>(t.stages()), t.error_order, t.dense_order, &t});
  }
  all.push_back({"symplectic_euler", "Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), I.1.2",
                 MethodKind::symplectic, 1, 2, 0, 3});
  all.push_back(
      {"verlet",
       "Störmer, Arch. Sci. Phys. Nat. 24 (1907); Verlet, Phys. Rev. 159 (1967) 98–103; Hairer, Lubich, "
       "Wanner, Geometric Numerical Integration (2006), I.1.4",
       MethodKind::symplectic, 2, 3, 0, 3});
  all.push_back(
      {"radau5",
       "Radau IIA: Ehle, Univ. of Waterloo CSRR 2010 (1969); Hairer, Wanner, Solving ODE II (1996), IV.5 "
       "and IV.8",
       MethodKind::implicit, Radau::kOrder, Radau::kStages, Radau::kErrorOrder, 3});
  return all;
}

SymplecticMethod symplectic_method(const Method& method) {
  return method.order == 1 ? SymplecticMethod::euler : SymplecticMethod::verlet;
}

template <class Core>
std::unique_ptr<Stepper> equal(Core core, const Method& method, const EqualTimes& times,
                               const Checkpoint* from) {
  auto stepper = std::make_unique<EqualSteps<Core>>(std::move(core), method.name, times);
  if (from) stepper->resume(*from);
  return stepper;
}

template <class Core>
std::unique_ptr<Stepper> adaptive(Core core, const Method& method, const Problem& problem,
                                  const Adaptive& steps, const Checkpoint* from) {
  const AdaptiveMethod orders = {method.name, method.order, method.error_order};
  auto stepper =
      std::make_unique<AdaptiveSteps<Core>>(std::move(core), orders, problem.derivative,
                                            from ? from->t : problem.t0, steps.tolerance, steps.largest);
  if (from) stepper->resume(*from);
  return stepper;
}

std::unique_ptr<Stepper> make_equal(const Method& method, const Problem& problem, std::span<const double> y,
                                    const EqualTimes& times, const Checkpoint* from) {
  if (method.kind == MethodKind::symplectic) {
    return equal(Symplectic(symplectic_method(method), problem.derivative, y, problem.positions()), method,
                 times, from);
  }
  if (method.kind == MethodKind::implicit) {
    const Tolerance tight({kFixedStepTolerance}, {kFixedStepTolerance}, y.size());
    return equal(Radau(problem.derivative, problem.jacobian, y, tight), method, times, from);
  }
  return equal(RungeKutta(*method.tableau, problem.derivative, y), method, times, from);
}

std::unique_ptr<Stepper> make_adaptive(const Method& method, const Problem& problem,
                                       std::span<const double> y, const Adaptive& steps,
                                       const Checkpoint* from) {
  assert(method.is_adaptive());
  if (method.kind == MethodKind::implicit) {
    return adaptive(Radau(problem.derivative, problem.jacobian, y, steps.tolerance), method, problem, steps,
                    from);
  }
  return adaptive(RungeKutta(*method.tableau, problem.derivative, y), method, problem, steps, from);
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> kMethods = all_methods();
  return kMethods;
}

const Method& method_named(std::string_view name) {
  const std::string folded = fold(name);
  for (const Method& method : methods()) {
    if (method.name == folded) return method;
  }
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(method.name);
  const std::string nearest = nearest_name(folded, names);
  throw Error(Code::unknown_name, fmt::format("no method is named '{}'", name), "method",
              nearest.empty()
                  ? fmt::format("use one of {}", fmt::join(names, ", "))
                  : fmt::format("did you mean '{}'? There are {}", nearest, fmt::join(names, ", ")));
}

std::unique_ptr<Stepper> equal_stepper(const Method& method, const Problem& problem, double step) {
  return make_equal(method, problem, problem.y, {problem.t0, step, 0}, nullptr);
}

std::unique_ptr<Stepper> adaptive_stepper(const Method& method, const Problem& problem,
                                          const Adaptive& steps) {
  return make_adaptive(method, problem, problem.y, steps, nullptr);
}

std::unique_ptr<Stepper> resumed_stepper(const Method& method, const Problem& problem, const Checkpoint& from,
                                         const std::optional<Adaptive>& steps) {
  if (steps) return make_adaptive(method, problem, from.y, *steps, &from);
  return make_equal(method, problem, from.y, {from.origin, from.control.step, from.steps}, &from);
}

}  // namespace animado::fred
