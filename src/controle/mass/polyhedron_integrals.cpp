// A polyhedron is the signed sum of the tetrahedra (o, p, q, r) that a point o forms with the triangles (p,
// q, r) of its faces. With V = p·(q × r)/6, the corners taken from o, a tetrahedron has
//   ∫ x = V s/4,   ∫ x xᵀ = V (p pᵀ + q qᵀ + r rᵀ + s sᵀ)/20,   s = p + q + r,
// which is exact (Tonon, Explicit exact formulas for the 3-D tetrahedron inertia tensor, J. Math. Stat. 1(1),
// 2005). The point o is the mean of the vertices, so that a polyhedron far from its origin loses no digits.
#include "controle/mass/polyhedron_integrals.hpp"

namespace animado::controle {
namespace {

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return points.empty() ? sum : Vec3(sum / static_cast<double>(points.size()));
}

}  // namespace

VolumeIntegrals integrate(const Hull& polyhedron) {
  const Vec3 o = mean(polyhedron.vertices_m);
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const std::vector<int>& face : polyhedron.faces) {
    const auto corner = [&](size_t k) {
      return Vec3(polyhedron.vertices_m[static_cast<size_t>(face[k])] - o);
    };
    for (size_t k = 1; k + 1 < face.size(); ++k) {
      const Vec3 p = corner(0), q = corner(k), r = corner(k + 1), s = p + q + r;
      const double v = p.dot(q.cross(r)) / 6;
      volume += v;
      first += v / 4 * s;
      second += v / 20 * (p * p.transpose() + q * q.transpose() + r * r.transpose() + s * s.transpose());
    }
  }
  if (volume == 0) return {};
  const Vec3 c = first / volume;
  return {volume, o + c, second - volume * c * c.transpose()};
}

}  // namespace animado::controle
