// Many systems that have their equations in common and nothing else, as bodies that turn freely or one motion
// from many starts. They are integrated in groups, each so small that what its steps read stays in the first
// cache.
#pragma once

#include <functional>
#include <memory>

#include "fred/integrate.hpp"
#include "fred/methods.hpp"

namespace animado::fred {

struct Ensemble {
  // Puts f(t, y) of `count` systems, from `first` on, into rate. y, rate: (unknowns, count), so that
  // neighbouring numbers belong to neighbouring systems and one instruction serves several.
  std::function<void(double t, size_t first, size_t count, const double* y, double* rate)> derivative;
  double t0 = 0;
  size_t unknowns = 0;
  std::vector<double> y;  // (unknowns, systems)

  size_t systems() const { return y.size() / unknowns; }
};

struct EnsembleSolution {
  std::vector<double> y;  // (unknowns, systems), each where its group stopped
  // The first group that did not reach the end: why, when, and its systems. Of none: Stop::end at t1.
  Stop stop = Stop::end;
  double t = 0;
  size_t first = 0, count = 0;
};

// How many systems go together: their share of the first cache, in whole registers.
size_t group_size(const Method& method, size_t unknowns);

// make: sets the method to work on one group, as by equal_stepper or adaptive_stepper; with equal steps the
// bits of a system do not depend on the others.
EnsembleSolution integrate(const Method& method, const Ensemble& ensemble, double t1,
                           const std::function<std::unique_ptr<Stepper>(const Problem&)>& make);

}  // namespace animado::fred
