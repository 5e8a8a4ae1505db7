// src/controle/results/tessellate.cpp: one suite for every shape.
#include "controle/results/tessellate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace animado::controle {
namespace {

// 48 sides around and 48 on a meridian lose 1 − sin(2π/48)/(2π/48) = 0.29 % of a circle's area, and of a
// sphere less than thrice that.
constexpr double kPolygonLoss = 0.009;

struct Case {
  std::string name;
  Shape shape;
  double volume_m3;
  double loss;  // of the volume, relative
  Vec3 centroid_m = Vec3::Zero();
};

Hull tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Hull brick() {  // faces of four corners
  return {{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}}};
}

const Case kCases[] = {
    {"sphere", Sphere{2}, 4.0 / 3 * std::numbers::pi * 8, kPolygonLoss},
    {"box", Box{{1, 2, 3}}, 48, 0},
    {"capsule", Capsule{1, 2}, 4.0 / 3 * std::numbers::pi + std::numbers::pi * 4, kPolygonLoss},
    {"cylinder", Cylinder{1, 2}, std::numbers::pi * 4, kPolygonLoss},
    {"cone", Cone{1, 3}, std::numbers::pi, kPolygonLoss},
    {"tetrahedron", tetrahedron(), 1.0 / 6, 0, {0.25, 0.25, 0.25}},
    {"brick", brick(), 6, 0, {0.5, 1, 1.5}},
};

class Solid : public testing::TestWithParam<Case> {
 protected:
  const TriangleMesh mesh_ = tessellate(GetParam().shape, 1);

  const Vec3& corner(size_t index) const { return mesh_.positions_m[mesh_.triangles[index]]; }
};

// The divergence theorem, with the signs of the triangles' turns: a hole or an inverted triangle shows.
TEST_P(Solid, VolumeIsThatOfTheShape) {
  double volume_m3 = 0;
  for (size_t t = 0; t < mesh_.triangles.size(); t += 3)
    volume_m3 += corner(t).dot(corner(t + 1).cross(corner(t + 2))) / 6;
  const double exact_m3 = GetParam().volume_m3;
  EXPECT_LE(volume_m3, exact_m3 * (1 + 1e-12));  // corners are on a convex surface
  EXPECT_GE(volume_m3, exact_m3 * (1 - GetParam().loss - 1e-12));
}

TEST_P(Solid, CentroidIsTheOneOfTheShape) {
  Vec3 moment = Vec3::Zero();
  double volume_m3 = 0;
  for (size_t t = 0; t < mesh_.triangles.size(); t += 3) {
    const double part_m3 = corner(t).dot(corner(t + 1).cross(corner(t + 2))) / 6;
    moment += part_m3 * (corner(t) + corner(t + 1) + corner(t + 2)) / 4;
    volume_m3 += part_m3;
  }
  EXPECT_LT((moment / volume_m3 - GetParam().centroid_m).norm(), 1e-12);
}

// Every edge is walked once each way: the surface has no gap.
TEST_P(Solid, SurfaceIsClosed) {
  std::map<std::tuple<long, long, long, long, long, long>, int> balance;
  const auto nano = [](double x) { return std::lround(x * 1e9); };
  for (size_t t = 0; t < mesh_.triangles.size(); t += 3) {
    for (size_t side = 0; side < 3; ++side) {
      const Vec3 &a = corner(t + side), &b = corner(t + (side + 1) % 3);
      ++balance[{nano(a.x()), nano(a.y()), nano(a.z()), nano(b.x()), nano(b.y()), nano(b.z())}];
      --balance[{nano(b.x()), nano(b.y()), nano(b.z()), nano(a.x()), nano(a.y()), nano(a.z())}];
    }
  }
  for (const auto& [edge, count] : balance) EXPECT_EQ(count, 0);
}

TEST_P(Solid, NormalsAreUnitAndOutward) {
  ASSERT_EQ(mesh_.normals.size(), mesh_.positions_m.size());
  for (const Vec3& normal : mesh_.normals) EXPECT_NEAR(normal.norm(), 1, 1e-12);
  for (size_t t = 0; t < mesh_.triangles.size(); t += 3) {
    const Vec3 flat = (corner(t + 1) - corner(t)).cross(corner(t + 2) - corner(t));
    EXPECT_GT(flat.norm(), 0) << "a triangle without area";
    // A cone's normals turn most at its tip, by 2π/48 to the next.
    for (size_t k = 0; k < 3; ++k)
      EXPECT_GT(mesh_.normals[mesh_.triangles[t + k]].dot(flat.normalized()), 0.98);
  }
}

INSTANTIATE_TEST_SUITE_P(Tessellate, Solid, testing::ValuesIn(kCases),
                         [](const auto& shape_info) { return shape_info.param.name; });

TEST(Tessellate, SphereIsSmoothAndItsCornersLieOnIt) {
  const TriangleMesh mesh = tessellate(Sphere{2}, 1);
  for (size_t i = 0; i < mesh.positions_m.size(); ++i) {
    EXPECT_NEAR(mesh.positions_m[i].norm(), 2, 1e-12);
    EXPECT_LT((mesh.normals[i] - mesh.positions_m[i] / 2).norm(), 1e-12);
  }
}

TEST(Tessellate, AHalfSpaceIsASquareOnItsPlane) {
  const HalfSpace plane{Vec3(1, 2, 2) / 3, 1.5};
  const TriangleMesh mesh = tessellate(plane, 10);
  ASSERT_EQ(mesh.triangles.size(), 6u);
  Vec3 area = Vec3::Zero(), center = Vec3::Zero();
  for (const Vec3& corner : mesh.positions_m) {
    EXPECT_NEAR(plane.normal.dot(corner), 1.5, 1e-12);
    center += corner / 4;
  }
  for (size_t t = 0; t < 6; t += 3) {
    const Vec3 &a = mesh.positions_m[mesh.triangles[t]], &b = mesh.positions_m[mesh.triangles[t + 1]],
               &c = mesh.positions_m[mesh.triangles[t + 2]];
    area += (b - a).cross(c - a) / 2;
  }
  EXPECT_LT((area - 400 * plane.normal).norm(), 1e-10);  // 20 m × 20 m, facing out
  EXPECT_LT((center - 1.5 * plane.normal).norm(), 1e-12);
}

}  // namespace
}  // namespace animado::controle
