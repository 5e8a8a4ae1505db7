// src/controle/mass/polyhedron_integrals.cpp
#include "controle/mass/polyhedron_integrals.hpp"

#include <gtest/gtest.h>

namespace animado::controle {
namespace {

// The corner of a unit cube cut off by x + y + z = 1: volume 1/6, centroid 1/4, ∫ x² = 1/60, ∫ xy = 1/120.
Hull corner() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
}

Hull box(const Vec3& from, const Vec3& size) {
  Hull hull;
  for (int k = 0; k < 8; ++k)
    hull.vertices_m.push_back(from + Vec3(k & 1 ? size.x() : 0, k & 2 ? size.y() : 0, k & 4 ? size.z() : 0));
  hull.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return hull;
}

TEST(PolyhedronIntegrals, TetrahedronHasTheTextbookIntegrals) {
  const VolumeIntegrals v = integrate(corner());
  EXPECT_NEAR(v.volume_m3, 1.0 / 6, 1e-15);
  EXPECT_NEAR((v.centroid_m - Vec3::Constant(0.25)).norm(), 0, 1e-15);
  // About the centroid: 1/60 − 1/6·1/16 and 1/120 − 1/6·1/16.
  EXPECT_NEAR(v.second_moment_m5(0, 0), 1.0 / 60 - 1.0 / 96, 1e-16);
  EXPECT_NEAR(v.second_moment_m5(0, 1), 1.0 / 120 - 1.0 / 96, 1e-16);
}

TEST(PolyhedronIntegrals, BoxFarFromTheOriginKeepsItsDigits) {
  const Vec3 from(1000, -2000, 3000), size(1, 2, 3);
  const VolumeIntegrals v = integrate(box(from, size));
  EXPECT_NEAR(v.volume_m3, 6, 1e-10);
  EXPECT_NEAR((v.centroid_m - from - size / 2).norm(), 0, 1e-10);
  // The coordinates carry 1e-13 of rounding at this distance, the moments a few times that.
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(v.second_moment_m5(k, k), 6 * size[k] * size[k] / 12, 1e-11);
  EXPECT_NEAR(v.second_moment_m5(0, 2), 0, 1e-11);
}

TEST(PolyhedronIntegrals, FacesTurnedInsideOutGiveANegativeVolume) {
  Hull inside_out = corner();
  for (auto& face : inside_out.faces) std::reverse(face.begin(), face.end());
  EXPECT_NEAR(integrate(inside_out).volume_m3, -1.0 / 6, 1e-15);
}

}  // namespace
}  // namespace animado::controle
