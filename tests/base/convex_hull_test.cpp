// base/convex_hull.cpp: hulls of point sets, degenerate ones too.
#include "base/convex_hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "base/error.hpp"

namespace animado {
namespace {

// Closed, outward, convex, holding all points; and V − E + F = 2.
void expect_hull_of(const std::vector<Vec3>& points, const Hull& hull, size_t vertices, size_t faces) {
  EXPECT_EQ(hull.vertices_m.size(), vertices);
  EXPECT_EQ(hull.faces.size(), faces);
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : hull.faces) {
    const auto at = [&](size_t k) { return hull.vertices_m[static_cast<size_t>(face[k % face.size()])]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    for (const Vec3& p : points) EXPECT_LE(normal.dot(p - at(0)), 1e-9);
    for (size_t k = 0; k < face.size(); ++k) ++edges[{face[k], face[(k + 1) % face.size()]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.count({edge.second, edge.first}));
  }
  EXPECT_EQ(vertices + faces, edges.size() / 2 + 2);
}

TEST(ConvexHull, ACubeAmongManyPointsOfItsFacesEdgesAndInside) {
  std::vector<Vec3> points;
  for (int i = 0; i < 7 * 7 * 7; ++i) points.emplace_back(i % 7 / 6.0, i / 7 % 7 / 6.0, i / 49 / 6.0);
  points.insert(points.end(), points.begin(), points.begin() + 100);
  expect_hull_of(points, convex_hull(points), 8, 6);
}

TEST(ConvexHull, ATurnedCubeIsStillACube) {
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  std::vector<Vec3> points;
  for (int i = 0; i < 125; ++i) points.push_back(Vec3(100, 7, -3) + turn * Vec3(i % 5, i / 5 % 5, i / 25));
  expect_hull_of(points, convex_hull(points), 8, 6);
}

TEST(ConvexHull, APrismHasItsPolygons) {
  std::vector<Vec3> points;
  for (int k = 0; k < 24; ++k) {
    const double angle = k % 12 * std::numbers::pi / 6;
    points.emplace_back(std::cos(angle), k / 12, std::sin(angle));
  }
  expect_hull_of(points, convex_hull(points), 24, 14);
}

TEST(ConvexHull, PointsOfASphereAreAllCorners) {
  std::vector<Vec3> points;
  for (int i = 0; i < 1500; ++i) {
    const double z = 1 - (2.0 * i + 1) / 1500, angle = i * 2.399963229728653;
    points.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  const Hull hull = convex_hull(points);
  expect_hull_of(points, hull, 1500, 2 * 1500 - 4);
  EXPECT_EQ(hull.vertices_m, points);  // the order of the input
}

TEST(ConvexHull, WhatEnclosesNothingIsRefused) {
  const std::vector<Vec3> few{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Vec3> flat;
  for (int i = 0; i < 16; ++i) flat.emplace_back(i % 4, i / 4, i % 4 + 2 * (i / 4));
  for (const auto& points : {few, flat, std::vector<Vec3>(9, Vec3(1, 2, 3))}) {
    try {
      convex_hull(points);
      ADD_FAILURE() << "accepted";
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), Code::refused);
    }
  }
  EXPECT_THROW(convex_hull(std::vector<Vec3>(5, Vec3(0, NAN, 0))), Error);
}

}  // namespace
}  // namespace animado
