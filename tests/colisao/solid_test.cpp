// colisao/solid.cpp, curved_feature.cpp and polyhedron.cpp: supports, features, and what is refused.
#include "colisao/solid.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

class EverySolid : public testing::TestWithParam<size_t> {
 protected:
  const Named named = one_of_each()[GetParam()];
  const Solid& solid = named.solid;
};

// The feature that faces a direction holds the farthest point, and nothing of it is nearer than the tilt
// allows.
TEST_P(EverySolid, FeaturesLieAtTheSupport) {
  Random random(81);
  for (int k = 0; k < 500; ++k) {
    Vec3 d = random.direction();
    if (k % 3 == 0) d = Vec3::Unit(k % 9 / 3) * (k % 2 ? 1 : -1);
    const double reach = d.dot(solid.support(d));
    EXPECT_LE(solid.support(d).norm(), solid.radius_m() + 1e-12);
    const Feature f = solid.feature(d, 1e-4);
    double most = -1e9;
    for (const Vec3& p : f.points_m) {
      most = std::max(most, d.dot(p));
      EXPECT_NEAR(d.dot(p), reach, 1e-3);
    }
    EXPECT_NEAR(most, reach, 1e-4);
    EXPECT_EQ(f.id, solid.feature(d, 1e-4).id);
    if (f.is_face()) {
      EXPECT_LT((f.normal - d).norm(), 1.1e-4);
      const Vec3 turn = (f.points_m[1] - f.points_m[0]).cross(f.points_m[2] - f.points_m[1]);
      EXPECT_GT(turn.dot(f.normal), 0) << "clockwise";
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Shapes, EverySolid, testing::Range<size_t>(0, 6),
                         [](const auto& solid) { return one_of_each()[solid.param].name; });

std::string refusal(Shape shape) {
  try {
    Solid solid(std::move(shape));
  } catch (const Error& e) {
    EXPECT_FALSE(e.remedy().empty());
    return std::string(name_of(e.code())) + ": " + e.message();
  }
  return "accepted";
}

TEST(Solid, NonsenseIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(Sphere{0}), "refused: a length is not positive");
  EXPECT_EQ(refusal(Box{{1, -1, 1}}), "refused: a length is not positive");
  EXPECT_EQ(refusal(Cylinder{nan, 1}), "not_finite: a length is not finite");
  EXPECT_EQ(refusal(HalfSpace{{0, 2, 0}, 0}), "refused: the normal of a plane is not a unit vector");
}

TEST(Solid, HullsMustBeClosedConvexAndOutward) {
  const Hull good = some_hull();
  EXPECT_EQ(refusal(good), "accepted");
  Hull open = good;
  open.faces.pop_back();
  EXPECT_EQ(refusal(open), "refused: the surface is not closed");
  Hull inward = good;
  for (auto& face : inward.faces) std::reverse(face.begin(), face.end());
  EXPECT_NE(refusal(inward), "accepted");
  Hull dented = good;
  dented.vertices_m[0] *= 0.3;
  EXPECT_NE(refusal(dented), "accepted");
  Hull wild = good;
  wild.faces[0][0] = 999;
  EXPECT_EQ(refusal(wild), "refused: a face names a vertex that is not there");
}

TEST(Solid, TrianglesOfAFaceAreMerged) {
  Hull cube;
  const Polyhedron box = make_polyhedron(Box{{1, 2, 3}});
  cube.vertices_m = box.vertices_m;
  for (const auto& face : box.faces) {
    cube.faces.push_back({face.vertices[0], face.vertices[1], face.vertices[2]});
    cube.faces.push_back({face.vertices[0], face.vertices[2], face.vertices[3]});
  }
  const Solid solid(cube);
  EXPECT_EQ(solid.polyhedron()->faces.size(), 6u);
  EXPECT_EQ(solid.polyhedron()->edges.size(), 12u);
  EXPECT_NEAR(solid.size_m(), 1, 1e-15);
}

}  // namespace
}  // namespace animado::colisao
