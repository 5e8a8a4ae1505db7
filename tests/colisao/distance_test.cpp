// colisao/distance.cpp: signed distances of every pair of shapes.
#include "colisao/distance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

// A spiral that covers the unit sphere.
const std::vector<Vec3>& directions() {
  static const std::vector<Vec3> all = [] {
    std::vector<Vec3> list;
    for (int i = 0; i < 2000; ++i) {
      const double z = 1 - (2.0 * i + 1) / 2000, angle = i * std::numbers::pi * (3 - std::sqrt(5.0)),
                   r = std::sqrt(1 - z * z);
      list.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    return list;
  }();
  return all;
}

double reach(const Solid& s, const Pose& pose, const Vec3& direction) {
  const Vec3 d = pose.orientation.conjugate() * direction;
  if (s.half_space()) {
    return (d - s.half_space()->normal).norm() < 1e-9
               ? direction.dot(pose.position_m) + s.half_space()->offset_m
               : std::numeric_limits<double>::infinity();
  }
  return direction.dot(pose.position_m) + d.dot(s.support(d));
}

double separation(const Solid& a, const Pose& at, const Solid& b, const Pose& bt, const Vec3& n) {
  return -reach(a, at, -n) - reach(b, bt, n);
}

// Whether a point is in a solid, but for a tolerance: no direction of a dense set sees it outside.
bool holds(const Solid& s, const Pose& pose, const Vec3& point, double tolerance) {
  for (const Vec3& d : directions()) {
    const Vec3 world = s.half_space() ? Vec3(pose.orientation * s.half_space()->normal) : d;
    if (world.dot(point) > reach(s, pose, world) + tolerance) return false;
  }
  return true;
}

class EveryPair : public testing::TestWithParam<std::tuple<size_t, size_t>> {
 protected:
  const Named first = one_of_each()[std::get<0>(GetParam())], second = one_of_each()[std::get<1>(GetParam())];
  const Solid &a = first.solid, &b = second.solid;
  bool two_planes() const { return a.half_space() && b.half_space(); }
  // Ascent towards the depth of curved solids ends where a step gains less than rounding takes: about 1e-9 of
  // the size.
  static double tolerance(const Gap& g) { return g.gap_m > 0 ? 1e-11 : 1e-6; }
  // Half-spaces are found far from their frame's origin too; poses stay within reach of every other solid.
  static constexpr double kSpread = 1.2;
};

// Two certificates, neither of which knows the algorithm: the nearest points are points of the solids and the
// gap apart, so it is at most the gap; the plane across the normal separates them by the gap, so it is at
// least the gap. For solids that overlap the first says that the depth is not overstated along this axis, and
// that no other axis is better is asked of every direction of the spiral.
TEST_P(EveryPair, IsTheLargestSeparationAndTheSmallestDistance) {
  Random random(11);
  for (int k = 0; k < 60 && !two_planes(); ++k) {
    const Pose at = random.pose(kSpread), bt = random.pose(kSpread);
    const Gap g = gap(a, at, b, bt);
    EXPECT_NEAR(g.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(separation(a, at, b, bt, g.normal), g.gap_m, g.gap_m > 0 ? 1e-9 : 2e-6) << k;
    EXPECT_LT((g.point_a_m - g.point_b_m - g.gap_m * g.normal).norm(), g.gap_m > 0 ? 1e-9 : 1e-4) << k;
    EXPECT_TRUE(holds(a, at, g.point_a_m, 1e-9)) << k;
    EXPECT_TRUE(holds(b, bt, g.point_b_m, 1e-9)) << k;
    for (const Vec3& d : directions())
      ASSERT_LE(separation(a, at, b, bt, d), g.gap_m + 1e-9) << k << ' ' << g.gap_m;
  }
}

TEST_P(EveryPair, IsTheSameFromBothSides) {
  Random random(12);
  for (int k = 0; k < 200 && !two_planes(); ++k) {
    const Pose at = random.pose(kSpread), bt = random.pose(kSpread);
    const Gap ab = gap(a, at, b, bt), ba = gap(b, bt, a, at);
    EXPECT_NEAR(ab.gap_m, ba.gap_m, tolerance(ab)) << k;
    if (ab.gap_m > 1e-3) {
      EXPECT_LT((ab.normal + ba.normal).norm(), 1e-5) << k;
    }
  }
}

TEST_P(EveryPair, DoesNotDependOnTheFrame) {
  Random random(13);
  for (int k = 0; k < 200 && !two_planes(); ++k) {
    const Pose at = random.pose(kSpread), bt = random.pose(kSpread), move = random.pose(5);
    const auto moved = [&](const Pose& p) {
      return Pose{move.to_world(p.position_m), move.orientation * p.orientation};
    };
    const Gap here = gap(a, at, b, bt);
    EXPECT_NEAR(here.gap_m, gap(a, moved(at), b, moved(bt)).gap_m, tolerance(here)) << k;
  }
}

TEST_P(EveryPair, MovingByTheGapMakesThemTouch) {
  Random random(15);
  for (int k = 0; k < 200 && !two_planes(); ++k) {
    Pose at = random.pose(kSpread);
    const Pose bt = random.pose(kSpread);
    const Gap g = gap(a, at, b, bt);
    at.position_m -= g.gap_m * g.normal;
    EXPECT_NEAR(gap(a, at, b, bt).gap_m, 0, g.gap_m > 0 ? 1e-10 : 1e-6) << k << ' ' << g.gap_m;
    at.position_m += 0.1 * g.normal;
    EXPECT_NEAR(gap(a, at, b, bt).gap_m, 0.1, 1e-6) << k << ' ' << g.gap_m;
  }
}

std::string pair_name(const testing::TestParamInfo<std::tuple<size_t, size_t>>& info) {
  const auto all = one_of_each();
  return all[std::get<0>(info.param)].name + "_" + all[std::get<1>(info.param)].name;
}
INSTANTIATE_TEST_SUITE_P(Shapes, EveryPair,
                         testing::Combine(testing::Range<size_t>(0, 7), testing::Range<size_t>(0, 7)),
                         pair_name);

constexpr double kExact = 1e-14;

TEST(Gap, SpheresByTheirCentres) {
  const Solid a(Sphere{0.5}), b(Sphere{0.25});
  EXPECT_NEAR(gap(a, {{3, 4, 0}, Quat::Identity()}, b, {}).gap_m, 5 - 0.75, kExact);
  EXPECT_NEAR(gap(a, {{0.3, 0.4, 0}, Quat::Identity()}, b, {}).gap_m, 0.5 - 0.75, kExact);
  const Gap same = gap(a, {}, b, {});
  EXPECT_NEAR(same.gap_m, -0.75, kExact);
  EXPECT_NEAR(same.normal.norm(), 1, kExact);
}

TEST(Gap, SphereAtAFaceAnEdgeACornerAndInsideABox) {
  const Solid ball(Sphere{0.5}), box(Box{{1, 1, 1}});
  const auto at = [&](double x, double y, double z) {
    return gap(ball, {{x, y, z}, Quat::Identity()}, box, {}).gap_m;
  };
  EXPECT_NEAR(at(2, 0.3, -0.2), 0.5, kExact);
  EXPECT_NEAR(at(4, 5, 0), 5 - 0.5, kExact);
  EXPECT_NEAR(at(2, 3, 3), 3 - 0.5, kExact);
  EXPECT_NEAR(at(0.9, 0, 0), -0.1 - 0.5, kExact);
  EXPECT_NEAR(at(0, 0, 0), -1.5, kExact);
}

TEST(Gap, SphereAndCylinder) {
  const Solid ball(Sphere{0.5}), cylinder(Cylinder{1, 2});
  const auto at = [&](double x, double y) {
    return gap(ball, {{x, y, 0}, Quat::Identity()}, cylinder, {}).gap_m;
  };
  EXPECT_NEAR(at(3, 1), 1.5, 1e-12);
  EXPECT_NEAR(at(0.5, 4), 1.5, 1e-12);
  EXPECT_NEAR(at(4, 6), 5 - 0.5, 1e-12);  // the rim at (1, 2)
  EXPECT_NEAR(at(0.75, 0), -0.25 - 0.5, 1e-12);
  EXPECT_NEAR(at(0.1, 1.8), -0.2 - 0.5, 1e-12);
}

TEST(Gap, SphereAndCone) {
  const Solid ball(Sphere{0.5}), cone(Cone{3, 4});  // base at y = −1, apex at y = 3, slope normal (4, 3)/5
  const auto at = [&](double x, double y) {
    return gap(ball, {{x, y, 0}, Quat::Identity()}, cone, {}).gap_m;
  };
  EXPECT_NEAR(at(1.5 + 1.6, 1 + 1.2), 2 - 0.5, 1e-12);
  EXPECT_NEAR(at(0, 5), 2 - 0.5, 1e-12);
  EXPECT_NEAR(at(1, -2), 1 - 0.5, 1e-12);
  EXPECT_NEAR(at(6, -5), 5 - 0.5, 1e-12);
  EXPECT_NEAR(at(0, -0.9), -0.1 - 0.5, 1e-12);
}

TEST(Gap, CapsulesThatCrossAndThatLieInLine) {
  const Solid a(Capsule{0.25, 1}), b(Capsule{0.5, 2});
  EXPECT_NEAR(gap(a, {{0, 0, 3}, about(Vec3::UnitX(), 0.0)}, b, {{0, 0, 0}, about(Vec3::UnitZ(), 1.2)}).gap_m,
              3 - 0.75, kExact);
  EXPECT_NEAR(gap(a, {{0, 5, 0}, Quat::Identity()}, b, {}).gap_m, 5 - 3 - 0.75, kExact);
  // Crossing axes: the way out is along the common perpendicular, by both radii.
  const Gap crossed = gap(a, {}, b, {{0, 0, 0}, about(Vec3::UnitX(), std::numbers::pi / 2)});
  EXPECT_NEAR(crossed.gap_m, -0.75, 1e-12);
  EXPECT_NEAR(std::abs(crossed.normal.x()), 1, 1e-9);
}

TEST(Gap, CylindersSideBySideAndCrossed) {
  const Solid a(Cylinder{0.5, 2}), b(Cylinder{1, 3});
  EXPECT_NEAR(gap(a, {{3, 0.4, 4}, Quat::Identity()}, b, {}).gap_m, 5 - 1.5, 1e-12);
  EXPECT_NEAR(gap(a, {{0, 0, 1.75}, about(Vec3::UnitZ(), 1.0)}, b, {}).gap_m, 0.25, 1e-12);
  EXPECT_NEAR(gap(a, {{0, 0, 1.25}, about(Vec3::UnitZ(), 1.0)}, b, {}).gap_m, -0.25, 1e-10);
}

// The edge of one cube hangs across the edge of the other: cross product of (1, 0, 1)/√2-like directions, gap
// along y.
TEST(Gap, EdgesThatCross) {
  const Solid cube(Box{{1, 1, 1}});
  const Quat edge_down = about(Vec3::UnitX(), std::numbers::pi / 4),
             edge_up = about(Vec3::UnitZ(), std::numbers::pi / 4);
  for (const double d : {0.3, 1e-3, 1e-7, 1e-11, 0.0, -1e-11, -1e-3, -0.3}) {
    const Gap g = gap(cube, {{0.1, 2 * std::sqrt(2) + d, -0.2}, edge_down}, cube, {{0, 0, 0}, edge_up});
    EXPECT_NEAR(g.gap_m, d, 2e-15) << d;
    EXPECT_LT((g.normal - Vec3::UnitY()).norm(), 1e-12) << d;
  }
}

TEST(Gap, NormalOfSharpSolidsStaysExactAsTheyTouch) {
  const Solid box(Box{{0.5, 0.5, 0.5}}), cylinder(Cylinder{0.5, 0.5}), cone(Cone{0.5, 1});
  const Quat tilted = about({1, 2, 3}, 0.7);
  for (const Solid* s : {&box, &cylinder, &cone}) {
    for (const double d : {1e-2, 1e-6, 1e-10, 1e-13, -1e-13, -1e-9, -1e-3}) {
      const Vec3 lowest = tilted * s->support(tilted.conjugate() * -Vec3::UnitY());
      const Pose at{Vec3(0.1, 0.5 + d, 0.05) - lowest, tilted};
      const Gap g = gap(*s, at, box, {});
      EXPECT_NEAR(g.gap_m, d, 1e-14) << d;
      EXPECT_LT((g.normal - Vec3::UnitY()).norm(), 1e-11) << d;
    }
  }
}

TEST(Gap, PlaneMeetsTheSupport) {
  const Solid plane(HalfSpace{{0, 0.6, 0.8}, 2}), ball(Sphere{0.5});
  const Gap g = gap(plane, {}, ball, {{1, 6, 8}, Quat::Identity()});
  EXPECT_NEAR(g.gap_m, 10 - 2 - 0.5, kExact);
  EXPECT_LT((g.normal + Vec3(0, 0.6, 0.8)).norm(), kExact);
  EXPECT_TRUE(std::isinf(gap(plane, {}, plane, {}).gap_m));
}

}  // namespace
}  // namespace animado::colisao
