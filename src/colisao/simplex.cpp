#include "colisao/simplex.hpp"

#include <algorithm>
#include <cmath>

namespace animado::colisao {
namespace {

// A nearest point on part of a simplex: the weights are 0 for the corners that do not take part.
struct Nearest {
  Vec3 point;
  std::array<double, 4> weight{};
  double squared = 0;
};

using Simplex4 = std::array<Vec3, 4>;

// Squared height of a triangle, relative to its edge and to its distance, from which its normal is trusted.
constexpr double kWellShaped = 1e-4;

Nearest at_corner(const Simplex4& w, size_t i) {
  Nearest n{w[i], {}, w[i].squaredNorm()};
  n.weight[i] = 1;
  return n;
}

Nearest on_line(const Simplex4& w, size_t i, size_t j) {
  const Vec3 along = w[j] - w[i];
  const double length2 = along.squaredNorm(), reach = -w[i].dot(along);
  if (!(reach > 0)) return at_corner(w, i);
  if (reach >= length2) return at_corner(w, j);
  Nearest n;
  n.weight[j] = reach / length2;
  n.weight[i] = 1 - n.weight[j];
  n.point = w[i] + n.weight[j] * along;
  n.squared = n.point.squaredNorm();
  return n;
}

void keep_nearer(Nearest& best, const Nearest& other) {
  if (other.squared < best.squared) best = other;
}

Nearest on_triangle(const Simplex4& w, size_t i, size_t j, size_t k, Search search) {
  const Vec3 normal = (w[j] - w[i]).cross(w[k] - w[i]);
  const double area2 = normal.squaredNorm();
  const std::array<size_t, 3> corner{i, j, k};
  std::array<double, 3> part{};
  bool inside = area2 > 0;
  const Vec3 foot = inside ? Vec3(normal * (normal.dot(w[i] + w[j] + w[k]) / (3 * area2))) : Vec3::Zero();
  for (size_t c = 0; c < 3 && area2 > 0; ++c) {
    const Vec3 &p = w[corner[(c + 1) % 3]], &q = w[corner[(c + 2) % 3]];
    part[c] = normal.dot((p - foot).cross(q - foot)) / area2;
    inside = inside && part[c] > 0;
  }
  Nearest best = at_corner(w, i);
  if (inside) {
    Nearest n{Vec3::Zero(), {}, 0};
    const double sum = part[0] + part[1] + part[2];
    for (size_t c = 0; c < 3; ++c) {
      n.weight[corner[c]] = part[c] / sum;
      n.point += n.weight[corner[c]] * w[corner[c]];
    }
    const double edge2 = std::max((w[j] - w[i]).squaredNorm(), (w[k] - w[i]).squaredNorm());
    if (area2 > kWellShaped * edge2 * std::max(edge2, w[i].squaredNorm())) n.point = foot;
    n.squared = n.point.squaredNorm();
    if (search == Search::quick) return n;
    keep_nearer(best, n);
  }
  for (size_t c = 0; c < 3; ++c) {
    if (search == Search::quick && area2 > 0 && part[c] > 0) continue;
    keep_nearer(best, on_line(w, corner[(c + 1) % 3], corner[(c + 2) % 3]));
  }
  return best;
}

Nearest in_tetrahedron(const Simplex4& w, Search search) {
  const double volume = (w[1] - w[0]).cross(w[2] - w[0]).dot(w[3] - w[0]);
  // Signed volumes of the tetrahedra that the origin makes with each face, in the orientation of `volume`.
  const std::array<double, 4> part{w[1].cross(w[2]).dot(w[3]), -w[0].cross(w[2]).dot(w[3]),
                                   w[0].cross(w[1]).dot(w[3]), -w[0].cross(w[1]).dot(w[2])};
  const double rounding = 1e-15 * std::pow(std::max({w[0].norm(), w[1].norm(), w[2].norm(), w[3].norm()}), 3);
  bool inside = true;
  for (double p : part) inside = inside && (volume > 0 ? p > rounding : p < -rounding);
  if (inside) {
    Nearest n;
    n.point = Vec3::Zero();
    const double sum = part[0] + part[1] + part[2] + part[3];
    for (size_t c = 0; c < 4; ++c) n.weight[c] = part[c] / sum;
    return n;
  }
  Nearest best = at_corner(w, 0);
  for (size_t c = 0; c < 4; ++c) {
    if (search == Search::quick && volume != 0 && (volume > 0 ? part[c] > 0 : part[c] < 0)) continue;
    keep_nearer(best, on_triangle(w, (c + 1) % 4, (c + 2) % 4, (c + 3) % 4, search));
  }
  return best;
}

}  // namespace

void Simplex::add(const Vec3& a, const Vec3& b) {
  const auto i = static_cast<size_t>(size++);
  of_a[i] = a;
  of_b[i] = b;
  point[i] = a - b;
}

Vec3 Simplex::weigh(const std::array<Vec3, 4>& points) const {
  Vec3 sum = Vec3::Zero();
  for (size_t i = 0; i < static_cast<size_t>(size); ++i) sum += weight[i] * points[i];
  return sum;
}

Vec3 reduce_to_nearest(Simplex& s, Search search) {
  Nearest n;
  switch (s.size) {
    case 1:
      n = at_corner(s.point, 0);
      break;
    case 2:
      n = on_line(s.point, 0, 1);
      break;
    case 3:
      n = on_triangle(s.point, 0, 1, 2, search);
      break;
    default:
      n = in_tetrahedron(s.point, search);
  }
  int kept = 0;
  for (size_t i = 0; i < static_cast<size_t>(s.size); ++i) {
    if (n.weight[i] == 0) continue;
    const auto to = static_cast<size_t>(kept++);
    s.point[to] = s.point[i];
    s.of_a[to] = s.of_a[i];
    s.of_b[to] = s.of_b[i];
    s.weight[to] = n.weight[i];
  }
  s.size = kept;
  return n.point;
}

}  // namespace animado::colisao
