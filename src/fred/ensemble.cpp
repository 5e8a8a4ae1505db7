#include "fred/ensemble.hpp"

#include <algorithm>
#include <cassert>

namespace animado::fred {
namespace {

constexpr size_t kCacheBytes = 28 * 1024;  // of 32 to 48 KiB: the right-hand side has its share
constexpr size_t kLanes = 8;               // of the widest registers

// Numbers of the systems first … first + count − 1, row by row.
void copy_group(const double* from, size_t from_stride, double* to, size_t to_stride, size_t rows,
                size_t count) {
  for (size_t row = 0; row < rows; ++row) std::copy_n(from + row * from_stride, count, to + row * to_stride);
}

}  // namespace

size_t group_size(const Method& method, size_t unknowns) {
  const size_t rows = static_cast<size_t>(method.stages) + 3;  // rates, the start, the end, a stage
  return std::max(kLanes, kCacheBytes / (rows * unknowns * sizeof(double)) / kLanes * kLanes);
}

EnsembleSolution integrate(const Method& method, const Ensemble& ensemble, double t1,
                           const std::function<std::unique_ptr<Stepper>(const Problem&)>& make) {
  assert(ensemble.unknowns > 0 && ensemble.y.size() % ensemble.unknowns == 0);
  const size_t systems = ensemble.systems(), rows = ensemble.unknowns;
  EnsembleSolution solution{ensemble.y, Stop::end, t1, 0, 0};
  Goal goal;
  goal.t1 = t1;
  const size_t size = group_size(method, rows);
  for (size_t first = 0; first < systems; first += size) {
    const size_t count = std::min(size, systems - first);
    const auto derivative = [&](double t, std::span<const double> y, std::span<double> rate) {
      ensemble.derivative(t, first, count, y.data(), rate.data());
    };
    Problem group{derivative, ensemble.t0, std::vector<double>(rows * count)};
    copy_group(ensemble.y.data() + first, systems, group.y.data(), count, rows, count);
    const Solution reached = integrate(*make(group), goal);
    copy_group(reached.y.data(), count, solution.y.data() + first, systems, rows, count);
    if (reached.stop == Stop::end || solution.stop != Stop::end) continue;
    solution.stop = reached.stop;
    solution.t = reached.t;
    solution.first = first;
    solution.count = count;
  }
  return solution;
}

}  // namespace animado::fred
