// colisao/manifold.cpp: the contact points of touching pairs.
#include "colisao/manifold.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

constexpr double kMargin = 1e-6;
const Quat kStill = Quat::Identity();

std::vector<Contact> contacts(const Solid& a, const Pose& at, const Solid& b, const Pose& bt,
                              double margin = kMargin) {
  std::vector<Contact> out;
  manifold(2, a, at, 5, b, bt, margin, out);
  std::set<int> features;
  for (const Contact& c : out) {
    EXPECT_EQ(c.a, 2);
    EXPECT_EQ(c.b, 5);
    EXPECT_NEAR(c.normal.norm(), 1, 1e-12);
    EXPECT_TRUE(features.insert(c.feature).second) << "two contacts with one feature";
  }
  return out;
}

Vec3 middle(const std::vector<Contact>& all) {
  Vec3 sum = Vec3::Zero();
  for (const Contact& c : all) sum += c.point_m / static_cast<double>(all.size());
  return sum;
}

void expect_all(const std::vector<Contact>& all, size_t count, ContactKind kind, const Vec3& normal,
                double gap) {
  EXPECT_EQ(all.size(), count);
  for (const Contact& c : all) {
    EXPECT_EQ(c.kind, kind);
    EXPECT_LT((c.normal - normal).norm(), 1e-9);
    EXPECT_NEAR(c.gap_m, gap, 1e-12);
  }
}

const Solid kPlane(HalfSpace{{0, 1, 0}, 0});
const Solid kCube(Box{{0.5, 0.5, 0.5}});
const Vec3 kUp = Vec3::UnitY(), kDown = -Vec3::UnitY();

TEST(Manifold, ApartIsNothing) {
  EXPECT_TRUE(contacts(kCube, {{0, 0.501, 0}, kStill}, kPlane, {}).empty());
}

TEST(Manifold, BoxOnAPlaneHasFourCorners) {
  const auto flat = contacts(kCube, {{3, 0.5 - 1e-8, 4}, kStill}, kPlane, {});
  expect_all(flat, 4, ContactKind::vertex_face, kUp, -1e-8);
  EXPECT_LT((middle(flat) - Vec3(3, -0.5e-8, 4)).norm(), 1e-12);
  expect_all(contacts(kPlane, {}, kCube, {{3, 0.5, 4}, kStill}), 4, ContactKind::vertex_face, kDown, 0);
}

TEST(Manifold, RockingBoxKeepsFourCornersWithTheirOwnGaps) {
  const auto all = contacts(kCube, {{0, 0.5, 0}, about(Vec3::UnitZ(), 1e-9)}, kPlane, {});
  ASSERT_EQ(all.size(), 4u);
  for (const Contact& c : all) EXPECT_NEAR(c.gap_m, 1e-9 * (c.point_m.x() > 0 ? 0.5 : -0.5), 1e-15);
}

TEST(Manifold, TiltedBoxStandsOnAnEdgeAndOnACorner) {
  const double half = std::sqrt(0.5);
  const auto edge = contacts(kCube, {{0, half, 0}, about(Vec3::UnitZ(), std::numbers::pi / 4)}, kPlane, {});
  expect_all(edge, 2, ContactKind::vertex_face, kUp, 0);
  const Quat on_corner = Quat::FromTwoVectors(Vec3(1, 1, 1), kDown);
  expect_all(contacts(kCube, {{0, std::sqrt(0.75), 0}, on_corner}, kPlane, {}), 1, ContactKind::vertex_face,
             kUp, 0);
}

TEST(Manifold, CubeOnCubeIsTheirCommonSquare) {
  expect_all(contacts(kCube, {{0, 1, 0}, kStill}, kCube, {}), 4, ContactKind::vertex_face, kUp, 0);
  const auto shifted = contacts(kCube, {{0.25, 1 + 1e-9, 0.5}, kStill}, kCube, {});
  expect_all(shifted, 4, ContactKind::vertex_face, kUp, 1e-9);
  EXPECT_LT((middle(shifted) - Vec3(0.125, 0.5 + 0.5e-9, 0.25)).norm(), 1e-9);
  const auto turned = contacts(kCube, {{0, 1, 0}, about(kUp, std::numbers::pi / 4)}, kCube, {});
  expect_all(turned, 8, ContactKind::vertex_face, kUp, 0);
  EXPECT_LT((middle(turned) - Vec3(0, 0.5, 0)).norm(), 1e-12);
}

TEST(Manifold, EdgesThatCrossDefineThePlaneTogether) {
  const double half = std::sqrt(0.5);
  const auto all = contacts(kCube, {{0.1, 2 * half, -0.2}, about(Vec3::UnitX(), std::numbers::pi / 4)}, kCube,
                            {{0, 0, 0}, about(Vec3::UnitZ(), std::numbers::pi / 4)});
  expect_all(all, 1, ContactKind::edge_edge, kUp, 0);
  EXPECT_LT((all[0].point_m - Vec3(0, half, -0.2)).norm(), 1e-9);
}

TEST(Manifold, VerticesAreJoinedByTheirLine) {
  const Vec3 corner(1, 1, 1), apart = Vec3(1, 2, 3).normalized() * 1e-7;
  const auto near = contacts(kCube, {corner + apart, kStill}, kCube, {});
  expect_all(near, 1, ContactKind::vertex_vertex, apart.normalized(), 1e-7);
}

TEST(Manifold, CoincidentVerticesTakeTheLineOfTheOrigins) {
  const auto touching = contacts(kCube, {{1, 1, 1}, kStill}, kCube, {});
  expect_all(touching, 1, ContactKind::vertex_vertex, Vec3(1, 1, 1).normalized(), 0);
}

TEST(Manifold, CoincidentEdgesTakeTheLineOfTheOriginsAcrossTheEdge) {
  const auto touching = contacts(kCube, {{1, 1, 0.2}, kStill}, kCube, {});
  expect_all(touching, 2, ContactKind::edge_edge, Vec3(1, 1, 0).normalized(), 0);
}

TEST(Manifold, CylinderUprightLyingAndTilted) {
  const Solid cylinder(Cylinder{0.5, 1});
  const auto upright = contacts(cylinder, {{0, 1, 0}, kStill}, kPlane, {});
  expect_all(upright, 8, ContactKind::vertex_face, kUp, 0);
  EXPECT_LT(middle(upright).norm(), 1e-12);
  const Quat lying = about(Vec3::UnitX(), std::numbers::pi / 2);
  expect_all(contacts(cylinder, {{0, 0.5, 0}, lying}, kPlane, {}), 2, ContactKind::vertex_face, kUp, 0);
  const Solid floor(Box{{3, 0.5, 3}});
  expect_all(contacts(cylinder, {{0, 1.5, 0}, kStill}, floor, {}), 8, ContactKind::vertex_face, kUp, 0);
  expect_all(contacts(cylinder, {{0, 1, 0}, lying}, floor, {}), 2, ContactKind::vertex_face, kUp, 0);
  const double tilt = 0.3, height = std::cos(tilt) + 0.5 * std::sin(tilt);
  expect_all(contacts(cylinder, {{0, height, 0}, about(Vec3::UnitZ(), tilt)}, kPlane, {}), 1,
             ContactKind::vertex_face, kUp, 0);
}

TEST(Manifold, DiscsKeepTheirRoundness) {
  const Solid wide(Cylinder{1, 0.5}), narrow(Cylinder{0.25, 0.5});
  // A small disc within a large one, and two that overlap like a lens, whose tips are on both circles.
  expect_all(contacts(narrow, {{0.3, 1, 0}, kStill}, wide, {}), 8, ContactKind::vertex_face, kUp, 0);
  for (const Contact& c : contacts(wide, {{1, 1, 0}, kStill}, wide, {})) {
    const double r0 = std::hypot(c.point_m.x(), c.point_m.z()),
                 r1 = std::hypot(c.point_m.x() - 1, c.point_m.z());
    EXPECT_NEAR(std::max(r0, r1), 1, 1e-12);
  }
  // The corner of a box that hangs over the rim: the circle crosses its edges.
  for (const Contact& c : contacts(kCube, {{1, 1, 0.9}, kStill}, wide, {})) {
    EXPECT_LE(std::hypot(c.point_m.x(), c.point_m.z()), 1 + 1e-12);
    EXPECT_GE(c.point_m.x(), 0.5 - 1e-12);
    EXPECT_GE(c.point_m.z(), 0.4 - 1e-12);
  }
}

TEST(Manifold, ConeOnItsBaseAndOnItsSide) {
  const Solid cone(Cone{3, 4});
  expect_all(contacts(cone, {{0, 1, 0}, kStill}, kPlane, {}), 8, ContactKind::vertex_face, kUp, 0);
  const Quat on_side = Quat::FromTwoVectors(Vec3(4, 3, 0), kDown);
  // Distance of the centroid from the slope: (3 − 0) · 3/5 = 9/5.
  expect_all(contacts(cone, {{0, 1.8, 0}, on_side}, kPlane, {}), 2, ContactKind::vertex_face, kUp, 0);
  const Quat on_apex = about(Vec3::UnitX(), std::numbers::pi);
  expect_all(contacts(cone, {{0, 3, 0}, on_apex}, kPlane, {}), 1, ContactKind::vertex_face, kUp, 0);
}

TEST(Manifold, RoundOnesTouchInAPointAlongTheNormal) {
  const Solid ball(Sphere{0.5}), capsule(Capsule{0.5, 1});
  expect_all(contacts(ball, {{0, 1, 0}, kStill}, ball, {}), 1, ContactKind::vertex_face, kUp, 0);
  expect_all(contacts(ball, {{0.2, 1, 0.1}, kStill}, kCube, {}), 1, ContactKind::vertex_face, kUp, 0);
  expect_all(contacts(ball, {{0.5 + 0.3, 0.5 + 0.4, 0}, kStill}, kCube, {}), 1, ContactKind::vertex_face,
             Vec3(0.6, 0.8, 0), 0);
  const Quat lying = about(Vec3::UnitZ(), std::numbers::pi / 2);
  expect_all(contacts(capsule, {{0, 0.5, 0}, lying}, kPlane, {}), 2, ContactKind::vertex_face, kUp, 0);
  const auto across = contacts(capsule, {{0, 1, 0}, lying}, kCube, {});
  expect_all(across, 2, ContactKind::vertex_face, kUp, 0);
  EXPECT_NEAR(std::abs(across[0].point_m.x()), 0.5, 1e-12);
  expect_all(
      contacts(capsule, {{0, 1, 0}, lying}, capsule, {{0, 0, 0}, about(Vec3::UnitX(), std::numbers::pi / 2)}),
      1, ContactKind::vertex_face, kUp, 0);
}

// Whatever the shapes: a pair within the margin has a contact, none reaches beyond the margin, and the
// deepest is the gap.
TEST(Manifold, EveryTouchingPairHasAContactAtItsGap) {
  const auto all = one_of_each();
  Random random(31);
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t j = 0; j < all.size(); ++j) {
      const Solid &a = all[i].solid, &b = all[j].solid;
      if (a.half_space() && b.half_space()) continue;
      for (int k = 0; k < 40; ++k) {
        Pose at = random.pose(2);
        const Pose bt = random.pose(1);
        Gap g = gap(a, at, b, bt);
        if (g.gap_m < 0) continue;
        at.position_m -= (g.gap_m - 1e-8) * g.normal;
        const auto found = contacts(a, at, b, bt);
        ASSERT_FALSE(found.empty()) << all[i].name << ' ' << all[j].name << ' ' << k;
        double least = kMargin;
        for (const Contact& c : found) least = std::min(least, c.gap_m);
        EXPECT_NEAR(least, 1e-8, 1e-9) << all[i].name << ' ' << all[j].name << ' ' << k;
        EXPECT_LT((found[0].normal - g.normal).norm(), 1e-4) << all[i].name << ' ' << all[j].name << ' ' << k;
      }
    }
  }
}

TEST(Manifold, FeaturesKeepTheirNumbersWhileTheBodySlides) {
  const auto before = contacts(kCube, {{0, 1, 0}, about(kUp, 0.3)}, Solid(Box{{2, 0.5, 2}}), {});
  const auto later =
      contacts(kCube, {{0.01, 1 - 1e-9, -0.02}, about(kUp, 0.31)}, Solid(Box{{2, 0.5, 2}}), {});
  ASSERT_EQ(before.size(), 4u);
  ASSERT_EQ(later.size(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(before[k].feature, later[k].feature);
    EXPECT_LT((before[k].point_m - later[k].point_m).norm(), 0.05);
  }
}

}  // namespace
}  // namespace animado::colisao
