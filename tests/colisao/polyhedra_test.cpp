// colisao/polyhedra.cpp: edges against faces, and the degenerate cases that the paper leaves out.
#include "colisao/polyhedra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "colisao/separating_axes.hpp"
#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

const Polyhedron kCubePolyhedron = make_polyhedron(Box{{0.5, 0.5, 0.5}});

std::vector<Crossing> with_cube_at(const Vec3& position, const Quat& orientation = Quat::Identity()) {
  return crossings(kCubePolyhedron, {position, orientation}, kCubePolyhedron, {});
}
int count(const std::vector<Crossing>& all, Meeting kind) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](const Crossing& c) { return c.kind == kind; }));
}

TEST(Crossings, AgreeWithSeparatingAxes) {
  const Solid box(Box{{0.5, 0.8, 0.3}}), hull(some_hull());
  Random random(41);
  int touching = 0;
  for (int k = 0; k < 4000; ++k) {
    const Solid &a = k % 2 ? box : hull, &b = k % 3 ? box : hull;
    const Pose at = random.pose(0.9), bt = random.pose(0.9);
    const double s = separating_axis(Placed(a, at, Vec3::Zero()), Placed(b, bt, Vec3::Zero())).separation_m;
    const bool meet = !crossings(*a.polyhedron(), at, *b.polyhedron(), bt).empty();
    EXPECT_EQ(meet, s <= 0) << k << ' ' << s;
    touching += meet;
  }
  EXPECT_GT(touching, 1000);
  EXPECT_LT(touching, 3000);
}

TEST(Crossings, AnEdgeThroughAFace) {
  const auto all = with_cube_at({0.8, 0.1, 0.2});
  // The four edges along x of either cube pierce a face of the other only where the cross-sections overlap.
  EXPECT_EQ(count(all, Meeting::edge_face) + count(all, Meeting::edge_edge), static_cast<int>(all.size()));
  for (const Crossing& c : all) EXPECT_LE(std::abs(c.point_m.x() - 0.4), 0.1 + 1e-12);
}

TEST(Crossings, ACornerInAFace) {
  const Quat on_corner = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, -1, 0));
  const auto all = with_cube_at({0.1, 0.5 + std::sqrt(0.75), 0.05}, on_corner);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, Meeting::vertex_face);
  EXPECT_LT((all[0].point_m - Vec3(0.1, 0.5, 0.05)).norm(), 1e-9);
}

TEST(Crossings, AnEdgeInAFace) {
  const auto all = crossings(
      make_polyhedron(Box{{0.2, 0.2, 0.2}}),
      {{0, 0.5 + 0.2 * std::sqrt(2.0), 0}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()))},
      kCubePolyhedron, {});
  ASSERT_EQ(all.size(), 2u);
  for (const Crossing& c : all) {
    EXPECT_EQ(c.kind, Meeting::vertex_face);
    EXPECT_NEAR(std::abs(c.point_m.x()), 0.2, 1e-12);
  }
  const auto across = crossings(
      kCubePolyhedron,
      {{0, 0.2 + 0.5 * std::sqrt(2.0), 0}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()))},
      make_polyhedron(Box{{0.2, 0.2, 0.2}}), {});
  ASSERT_EQ(across.size(), 2u);  // the long edge enters and leaves the small face
  EXPECT_EQ(count(across, Meeting::edge_edge), 2);
}

TEST(Crossings, EdgesThatCrossInAPoint) {
  const auto all =
      crossings(kCubePolyhedron,
                {{0.1, std::sqrt(2.0), -0.2}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()))},
                kCubePolyhedron, {{0, 0, 0}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()))});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, Meeting::edge_edge);
}

TEST(Crossings, EdgesThatOverlap) {
  const auto all = with_cube_at({1, 1, 0.25});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(count(all, Meeting::edge_overlap), 2);
  EXPECT_NEAR(std::abs(all[0].point_m.z() - all[1].point_m.z()), 0.75, 1e-12);
}

TEST(Crossings, AVertexOnAnEdge) {
  const Quat on_corner = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(-1, -1, 0));
  const auto all =
      with_cube_at(Vec3(0.5, 0.5, 0.1) + std::sqrt(0.75) * Vec3(1, 1, 0).normalized(), on_corner);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, Meeting::vertex_edge);
}

TEST(Crossings, VerticesThatMeet) {
  const auto all = with_cube_at({1, 1, 1});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, Meeting::vertex_vertex);
}

TEST(Crossings, CoincidentFacesAndCoincidentSolids) {
  EXPECT_EQ(count(with_cube_at({0, 1, 0}), Meeting::vertex_vertex), 4);
  EXPECT_EQ(with_cube_at({0, 1, 0}).size(), 4u);
  const auto same = with_cube_at({0, 0, 0});
  EXPECT_EQ(same.size(), 8u);
  EXPECT_EQ(count(same, Meeting::vertex_vertex), 8);
}

TEST(Crossings, ASolidInsideTheOther) {
  const Polyhedron small = make_polyhedron(Box{{0.1, 0.1, 0.1}});
  for (const auto& all :
       {crossings(small, {}, kCubePolyhedron, {}), crossings(kCubePolyhedron, {}, small, {})}) {
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].kind, Meeting::inside);
  }
}

TEST(Crossings, NoneWhenApart) {
  EXPECT_TRUE(with_cube_at({1.001, 0, 0}).empty());
  EXPECT_TRUE(
      with_cube_at({0.9, 0.9, 0}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()))).empty());
}

}  // namespace
}  // namespace animado::colisao
