#include "colisao/gjk.hpp"

#include <algorithm>
#include <limits>

#include "colisao/simplex.hpp"

namespace animado::colisao {
namespace {

constexpr int kMostIterations = 256;  // smooth cores need some tens, polyhedra fewer than ten
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

bool holds(const Simplex& s, const Vec3& w) {
  const auto end = s.point.begin() + s.size;
  return std::find(s.point.begin(), end, w) != end;
}

double extent_of(const Simplex& s) {
  double most = 0;
  for (size_t i = 0; i < static_cast<size_t>(s.size); ++i) {
    most = std::max({most, s.of_a[i].lpNorm<Eigen::Infinity>(), s.of_b[i].lpNorm<Eigen::Infinity>()});
  }
  return most;
}

}  // namespace

CoreDistance core_distance(const Placed& a, const Placed& b, const Vec3& shift, const Vec3& guess) {
  const Vec3 first = guess.isZero(0) ? Vec3(Vec3::UnitX()) : guess;
  Simplex simplex;
  simplex.add(a.core_support(-first) + shift, b.core_support(first));
  simplex.weight[0] = 1;
  Vec3 v = simplex.point[0];

  int iteration = 0;
  bool overlap = false;
  while (iteration++ < kMostIterations) {
    overlap = v.norm() <= 4 * kEpsilon * extent_of(simplex);
    if (overlap) break;
    const Vec3 on_a = a.core_support(-v) + shift, on_b = b.core_support(v), w = on_a - on_b;
    const double squared = v.squaredNorm();
    if (squared - v.dot(w) <= 1e-14 * squared || holds(simplex, w)) break;
    Simplex next = simplex;
    next.add(on_a, on_b);
    const Vec3 nearer = reduce_to_nearest(next);
    overlap = next.size == 4;
    if (overlap || !(nearer.squaredNorm() < squared)) break;
    simplex = next;
    v = nearer;
  }
  return {overlap, v, simplex.weigh(simplex.of_a), simplex.weigh(simplex.of_b), iteration};
}

}  // namespace animado::colisao
