// The iteration of gjk.hpp for any two support functions (world axes).
#pragma once

#include <algorithm>
#include <limits>

#include "colisao/gjk.hpp"
#include "colisao/simplex.hpp"

namespace animado::colisao {

// Largest coordinate of the supports: what rounding is measured by.
inline double extent_of(const Simplex& s) {
  double most = 0;
  for (size_t i = 0; i < static_cast<size_t>(s.size); ++i) {
    most = std::max({most, s.of_a[i].lpNorm<Eigen::Infinity>(), s.of_b[i].lpNorm<Eigen::Infinity>()});
  }
  return most;
}

template <class SupportA, class SupportB>
CoreDistance gjk(const SupportA& support_a, const SupportB& support_b, const Vec3& guess) {
  constexpr int kMostIterations = 256;  // smooth cores need some tens, polyhedra fewer than ten
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const Vec3 first = guess.isZero(0) ? Vec3(Vec3::UnitX()) : guess;
  Simplex simplex;
  simplex.add(support_a(-first), support_b(first));
  simplex.weight[0] = 1;
  Vec3 v = simplex.point[0];

  CoreDistance d{};
  while (d.iterations++ < kMostIterations) {
    const double extent = extent_of(simplex);
    d.overlap = v.norm() <= 4 * kEpsilon * extent;
    if (d.overlap) break;
    const Vec3 on_a = support_a(-v), on_b = support_b(v), w = on_a - on_b;
    const double squared = v.squaredNorm();
    d.error_m = (squared - v.dot(w)) / v.norm();
    const auto end = simplex.point.begin() + simplex.size;
    if (d.error_m <= kEpsilon * v.norm() || std::find(simplex.point.begin(), end, w) != end) break;
    Simplex next = simplex;
    next.add(on_a, on_b);
    Simplex reduced = next;
    Vec3 nearer = reduce_to_nearest(reduced, Search::quick);
    if (!(nearer.squaredNorm() < squared)) {
      reduced = next;
      nearer = reduce_to_nearest(reduced, Search::thorough);
    }
    d.overlap = reduced.size == 4;
    if (d.overlap || !(nearer.squaredNorm() < squared)) break;
    simplex = reduced;
    v = nearer;
  }
  d.separation = v;
  d.point_a_m = simplex.weigh(simplex.of_a);
  d.point_b_m = simplex.weigh(simplex.of_b);
  return d;
}

}  // namespace animado::colisao
