// The point of a simplex nearest to the origin.
//
// Signed volumes (Montanari, Petrinic, Barbieri, "Improving the GJK algorithm for faster and more reliable
// distance queries between convex objects", ACM Trans. Graph. 36(3), 2017, section 4): the origin is
// projected onto the simplex's plane or line, and when a barycentric coordinate is negative the search goes
// on in the faces opposite to it. Deviations: of a well shaped triangle the nearest
// point is taken from its plane, not summed from its corners, so that its direction is exact however near it
// is to the origin; and there is a thorough search that looks at every face, for the slivers that the
// supports of curved solids make, whose signs rounding has spoilt.
#pragma once

#include <array>

#include "base/spatial.hpp"

namespace animado::colisao {

struct Simplex {
  int size = 0;
  std::array<Vec3, 4> point;  // of the Minkowski difference, = of_a − of_b
  std::array<Vec3, 4> of_a, of_b;
  std::array<double, 4> weight{};  // barycentric coordinates of the nearest point

  void add(const Vec3& a, const Vec3& b);
  Vec3 weigh(const std::array<Vec3, 4>& points) const;
};

enum class Search { quick, thorough };

// Sets the weights, drops the corners of weight 0 and returns the nearest point. A simplex of size 4 on
// return holds the origin.
Vec3 reduce_to_nearest(Simplex& simplex, Search search);

}  // namespace animado::colisao
