#include "colisao/gjk.hpp"

#include "colisao/gjk_loop.hpp"
#include "colisao/slices.hpp"

namespace animado::colisao {

CoreDistance core_distance(const Placed& a, const Placed& b, const Vec3& shift, const Vec3& guess) {
  const CoreDistance d = gjk([&](const Vec3& v) { return Vec3(a.core_support(v) + shift); },
                             [&](const Vec3& v) { return b.core_support(v); }, guess);
  const double rounding = 5e-16 * (a.solid.size_m() + b.solid.size_m());
  if (d.overlap || d.error_m <= rounding) return d;
  return refine_by_slices(a, b, shift, d);
}

}  // namespace animado::colisao
