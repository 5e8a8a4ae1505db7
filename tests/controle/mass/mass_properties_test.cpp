// src/controle/mass/mass_properties.cpp
#include "controle/mass/mass_properties.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace animado::controle {
namespace {

constexpr double kPi = std::numbers::pi;

// A solid of revolution about y as a stack of thin discs of radius r(y): the moments by the midpoint rule.
template <class Radius>
MassProperties stacked(double from, double to, Radius radius) {
  constexpr int kDiscs = 200'000;
  const double thick = (to - from) / kDiscs;
  MassProperties sum;
  double across = 0, along = 0, first = 0;
  for (int k = 0; k < kDiscs; ++k) {
    const double y = from + (k + 0.5) * thick, r = radius(y), m = kPi * r * r * thick;
    sum.mass_kg += m;
    first += m * y;
    along += m * r * r / 2;
    across += m * (r * r / 4 + y * y);
  }
  sum.center_of_mass_m = {0, first / sum.mass_kg, 0};
  across -= sum.mass_kg * sum.center_of_mass_m.squaredNorm();
  sum.inertia_kg_m2 = Vec3(across, along, across).asDiagonal();
  return sum;
}

// 2e5 discs of the midpoint rule leave about 1e-10 of the value; the round cap's root a little more.
void expect_same(const MassProperties& a, const MassProperties& b) {
  EXPECT_NEAR(a.mass_kg, b.mass_kg, 1e-8 * b.mass_kg);
  EXPECT_NEAR((a.center_of_mass_m - b.center_of_mass_m).norm(), 0, 1e-8);
  EXPECT_NEAR((a.inertia_kg_m2 - b.inertia_kg_m2).norm(), 0, 1e-8 * b.inertia_kg_m2.norm());
}

TEST(MassProperties, SolidsOfRevolutionMatchTheirStackedDiscs) {
  expect_same(mass_properties(Sphere{0.7}, 1),
              stacked(-0.7, 0.7, [](double y) { return std::sqrt(0.49 - y * y); }));
  expect_same(mass_properties(Cylinder{0.3, 0.8}, 1), stacked(-0.8, 0.8, [](double) { return 0.3; }));
  expect_same(mass_properties(Cone{0.5, 2}, 1),
              stacked(-0.5, 1.5, [](double y) { return 0.5 * (1.5 - y) / 2; }));
  expect_same(mass_properties(Capsule{0.4, 0.6}, 1), stacked(-1, 1, [](double y) {
                const double beyond = std::max(0.0, std::abs(y) - 0.6);
                return std::sqrt(0.16 - beyond * beyond);
              }));
}

TEST(MassProperties, BoxHasItsClosedForm) {
  const MassProperties p = mass_properties(Box{{0.5, 1, 1.5}}, 10);
  EXPECT_DOUBLE_EQ(p.mass_kg, 60);
  EXPECT_DOUBLE_EQ(p.inertia_kg_m2(0, 0), 60.0 / 12 * (4 + 9));
  EXPECT_DOUBLE_EQ(p.inertia_kg_m2(1, 1), 60.0 / 12 * (1 + 9));
  EXPECT_DOUBLE_EQ(p.inertia_kg_m2(2, 2), 60.0 / 12 * (1 + 4));
}

TEST(MassProperties, HullThatIsABoxIsOne) {
  Hull hull;
  for (int k = 0; k < 8; ++k)
    hull.vertices_m.push_back({k & 1 ? 1.5 : 0.5, k & 2 ? 1.0 : -1.0, k & 4 ? 1.5 : -1.5});
  hull.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const MassProperties p = mass_properties(hull, 2), box = mass_properties(Box{{0.5, 1, 1.5}}, 2);
  EXPECT_NEAR(p.mass_kg, box.mass_kg, 1e-13);
  EXPECT_NEAR((p.center_of_mass_m - Vec3(1, 0, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((p.inertia_kg_m2 - box.inertia_kg_m2).norm(), 0, 1e-13);
}

TEST(MassProperties, HalfSpaceHasNoEnd) {
  EXPECT_TRUE(std::isinf(volume_m3(HalfSpace{Vec3::UnitY(), 0})));
}

TEST(PrincipalAxes, TurnATensorIntoItsMomentsAndBack) {
  const Quat turned = Quat(0.3, -0.5, 0.7, 0.1).normalized();
  const Mat3 r = turned.toRotationMatrix(), tensor = r * Vec3(3, 1, 2).asDiagonal() * r.transpose();
  const PrincipalAxes axes = principal_axes(tensor);
  EXPECT_NEAR((axes.moments_kg_m2 - Vec3(1, 2, 3)).norm(), 0, 1e-14);
  const Mat3 q = axes.orientation.toRotationMatrix();
  EXPECT_NEAR(q.determinant(), 1, 1e-14);
  EXPECT_NEAR((q * axes.moments_kg_m2.asDiagonal() * q.transpose() - tensor).norm(), 0, 1e-14);
}

TEST(InertiaTensor, IsRefusedWhenNoBodyCanHaveIt) {
  const auto diagonal = [](double x, double y, double z) { return Mat3(Vec3(x, y, z).asDiagonal()); };
  std::string why;
  EXPECT_TRUE(is_inertia(diagonal(1, 2, 3)));        // a flat plate: equality
  EXPECT_TRUE(is_inertia(diagonal(0.1, 0.2, 0.3)));  // the same, where 0.1 + 0.2 ≠ 0.3
  EXPECT_FALSE(is_inertia(diagonal(1, 1, 2.1), &why));
  EXPECT_NE(why.find("exceeds"), std::string::npos);
  EXPECT_FALSE(is_inertia(diagonal(0, 1, 1), &why));
  EXPECT_NE(why.find("positive definite"), std::string::npos);
  Mat3 skew = diagonal(2, 2, 2);
  skew(0, 1) = 0.5;
  EXPECT_FALSE(is_inertia(skew, &why));
  EXPECT_FALSE(is_inertia(diagonal(1, 1, std::nan("")), &why));
}

TEST(InertiaTensor, MovesToAParallelAxis) {
  // A point mass 2 m away from the axis: m d² on it, nothing on the axis through it.
  const Mat3 moved = inertia_about(Mat3::Zero(), 3, {2, 0, 0});
  EXPECT_DOUBLE_EQ(moved(0, 0), 0);
  EXPECT_DOUBLE_EQ(moved(1, 1), 12);
  EXPECT_DOUBLE_EQ(moved(2, 2), 12);
  EXPECT_DOUBLE_EQ(inertia_about(Mat3::Zero(), 3, {2, 1, 0})(0, 1), -6);  // −m x y
}

}  // namespace
}  // namespace animado::controle
