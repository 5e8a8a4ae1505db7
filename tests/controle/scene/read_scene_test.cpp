// src/controle/scene/read_*.cpp, scene.cpp: what a scene means.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "controle/mass/mass_properties.hpp"
#include "controle/scene/read_world.hpp"
#include "controle/scene/scene.hpp"
#include "fred/methods.hpp"

namespace animado::controle {
namespace {

using testing::ElementsAre;

constexpr const char* kTime = "\ntime\n end 1\n step 0.1\n";

Scene scene_of(const std::string& text) {
  return parse_scene(text + kTime);
}
Body ball_of(const std::string& lines) {
  return scene_of("object ball\n" + lines).bodies[0];
}

TEST(ReadScene, PaperExampleIsReadFigureByFigure) {
  const Scene scene = read_scene(ANIMADO_SOURCE_DIR "/scenes/colisao.animado");
  ASSERT_EQ(scene.bodies.size(), 2u);
  const Body &sphere = scene.bodies[0], &cube = scene.bodies[1];
  EXPECT_EQ(sphere.name, "esfera");
  EXPECT_EQ(std::get<Sphere>(sphere.shape).radius_m, 1);
  EXPECT_EQ(sphere.mass_kg, 2);
  EXPECT_EQ(sphere.restitution, 0.5);
  EXPECT_EQ(sphere.friction, 0);
  EXPECT_EQ(sphere.inertia_kg_m2, Mat3(4 * Mat3::Identity()));
  EXPECT_EQ(sphere.position_m, Vec3(0, 3, 0));
  EXPECT_EQ(sphere.velocity_m_s, Vec3(0, -0.5, 0));
  EXPECT_EQ(sphere.angular_velocity_rad_s, Vec3(5, 5, 5));
  EXPECT_EQ(cube.name, "cubo");
  EXPECT_EQ(std::get<Box>(cube.shape).half_m, Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(cube.mass_kg, 1.7);
  EXPECT_EQ(cube.restitution, 1);
  EXPECT_EQ(cube.velocity_m_s, Vec3(0, 0.7, 0));
  EXPECT_EQ(cube.angular_velocity_rad_s, Vec3(10, 0, 0));
  EXPECT_EQ(scene.world.gravity_m_s2, Vec3(0, 0, 0));
  EXPECT_EQ(scene.world.method, "rk4");
  EXPECT_EQ(scene.time.frames(), 12u);
  EXPECT_EQ(scene.where(sphere.places.at("mass")), scene.path + ":9:1");
}

TEST(ReadScene, EnglishAndPortugueseSayTheSame) {
  const Scene english = scene_of(
      "object ball\n mass 2\n friction 0.3\n initial position (1, 2, 3)\n force (0, 1, 0)\n colour "
      "red\nworld\n gravity (0, -1, 0)\n response spring\n "
      "spring k 10");
  const Scene portuguese = scene_of(
      "OBJETO ball\n Massa: 2\n coeficiente  de   ATRITO = 0.3\n posição inicial (1, 2, 3)\n força (0, 1, "
      "0)\n cor red\nMundo\n gravidade (0, -1, 0)\n "
      "resposta mola\n k da mola 10");
  const Body &a = english.bodies[0], &b = portuguese.bodies[0];
  EXPECT_EQ(a.mass_kg, b.mass_kg);
  EXPECT_EQ(a.friction, b.friction);
  EXPECT_EQ(a.position_m, b.position_m);
  EXPECT_EQ(a.forces[0].text, b.forces[0].text);
  EXPECT_EQ(a.color.r, b.color.r);
  EXPECT_EQ(english.world.gravity_m_s2, portuguese.world.gravity_m_s2);
  EXPECT_EQ(portuguese.world.response, Response::spring);
  EXPECT_EQ(portuguese.world.spring_stiffness_N_m, 10);
}

TEST(ReadScene, LeftOutPropertiesHaveTheirDefaults) {
  const Scene scene = scene_of("object ball\n mass 2");
  const Body& ball = scene.bodies[0];
  EXPECT_EQ(ball.motion, Motion::dynamic);
  EXPECT_EQ(ball.restitution, 0.5);
  EXPECT_EQ(ball.friction, 0);
  EXPECT_EQ(ball.orientation.coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(ball.inertia_kg_m2, mass_properties(Sphere{1}, 2 / volume_m3(Sphere{1})).inertia_kg_m2);
  EXPECT_EQ(ball.places.count("friction"), 0u);
  EXPECT_EQ(scene.world.contact_threshold_m_s, 0.01);
  EXPECT_EQ(scene.world.restitution_rule, RestitutionRule::product);
  EXPECT_FALSE(scene.world.substep_s);
  EXPECT_EQ(scene.time.start_s, 0);
}

TEST(ReadScene, ShapesByNameAreTheTable) {
  for (const std::string name : {"esfera", "sphere", "ball", "Ball"}) {
    EXPECT_EQ(std::get<Sphere>(scene_of("object " + name + "\n mass 1").bodies[0].shape).radius_m, 1);
  }
  for (const std::string name : {"cubo", "cube"}) {
    EXPECT_EQ(std::get<Box>(scene_of("object " + name + "\n mass 1").bodies[0].shape).half_m,
              Vec3::Constant(0.5));
  }
}

TEST(ReadScene, ShapesTakeTheirSizes) {
  const auto shape = [](const std::string& text) { return ball_of(" mass 1\n shape " + text).shape; };
  EXPECT_EQ(std::get<Sphere>(shape("sphere(radius = 0.5)")).radius_m, 0.5);
  EXPECT_EQ(std::get<Sphere>(shape("esfera(raio=1/4)")).radius_m, 0.25);
  EXPECT_EQ(std::get<Box>(shape("box(size=(1, 2, 3))")).half_m, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(std::get<Box>(shape("cube(edge=3)")).half_m, Vec3::Constant(1.5));
  EXPECT_EQ(std::get<Capsule>(shape("capsule(height=2, radius=0.1)")).half_height_m, 1);
  EXPECT_EQ(std::get<Cylinder>(shape("cylinder(radius=0.1, height=3)")).half_height_m, 1.5);
  EXPECT_EQ(std::get<Cone>(shape("cone(radius=0.1, height=3)")).height_m, 3);
}

TEST(ReadScene, PlaneIsBroughtToAUnitNormal) {
  const Body floor =
      scene_of("object floor\n motion static\n shape plane(normal=(0, 3, 4), offset=10)").bodies[0];
  const auto& plane = std::get<HalfSpace>(floor.shape);
  EXPECT_NEAR((plane.normal - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-16);
  EXPECT_DOUBLE_EQ(plane.offset_m, 2);  // (0, 3, 4)·x = 10
  EXPECT_EQ(floor.motion, Motion::fixed);
}

TEST(ReadScene, DensityTimesVolumeIsMass) {
  const Body body = ball_of(" shape box(size=(1, 2, 3))\n density 10");
  EXPECT_DOUBLE_EQ(body.mass_kg, 60);
  EXPECT_DOUBLE_EQ(body.inertia_kg_m2(0, 0), 60.0 / 12 * 13);
}

TEST(ReadScene, ProductsOfInertiaAreTheTensorsElements) {
  const Body body = ball_of(" mass 1\n moments of inertia (4, 5, 6)\n products of inertia (0.1, -0.2, 0.3)");
  Mat3 expected;
  expected << 4, 0.1, -0.2, 0.1, 5, 0.3, -0.2, 0.3, 6;
  EXPECT_EQ(body.inertia_kg_m2, expected);
}

TEST(ReadScene, RotationsFollowTheirOrder) {
  const Body paper = ball_of(" mass 1\n inclinacao (10 deg, 20 deg, 30 deg)");
  const auto about = [](double degrees, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
  };
  const Quat x = about(10, Vec3::UnitX()), y = about(20, Vec3::UnitY()), z = about(30, Vec3::UnitZ());
  EXPECT_NEAR(paper.orientation.angularDistance(z * y * x), 0, 1e-15);
  const Body other = ball_of(" mass 1\n rotation (10 deg, 20 deg, 30 deg)\n rotation order z, x, y");
  EXPECT_THAT(other.rotation_order, ElementsAre(2, 0, 1));
  EXPECT_NEAR(other.orientation.angularDistance(y * x * z), 0, 1e-15);
}

TEST(ReadScene, ForcesAddUpLineByLine) {
  const Body body = ball_of(" mass 1\n force (1, 0, 0)\n force (0, t, 0)\n local torque (0, 0, 1)");
  ASSERT_EQ(body.forces.size(), 2u);
  EXPECT_EQ(body.forces[1].text, "(0, t, 0)");
  EXPECT_EQ(body.forces[1].place.line, 4);
  EXPECT_EQ(body.forces[1].place.column, 8);
  EXPECT_EQ(body.local_torques.size(), 1u);
}

TEST(ReadScene, ConstantsUseNamesAndOtherMasses) {
  const Scene scene = scene_of(
      "box.edge = 2\nball.size = 1\nobject bola\n mass 2 * caixa.mass\n shape "
      "sphere(radius=ball.size/4)\nobject caixa\n shape cube(edge=box.edge)\n "
      "density 3\n position (mass, 0, 0)");
  EXPECT_DOUBLE_EQ(scene.bodies[1].mass_kg, 24);
  EXPECT_DOUBLE_EQ(scene.bodies[0].mass_kg, 48);
  EXPECT_EQ(std::get<Sphere>(scene.bodies[0].shape).radius_m, 0.25);
  EXPECT_EQ(scene.bodies[1].position_m.x(), 24);
  EXPECT_EQ(scene.names.size(), 2u);
}

TEST(ReadScene, GroupsAndColors) {
  const Scene scene = scene_of(
      "object ball\n mass 1\n group A\n color (0, 0.5, 1)\nobject cube\n mass 1\n group b\n collides with a, "
      "b\n color SteelBlue");
  EXPECT_EQ(scene.bodies[0].group, "a");
  EXPECT_THAT(scene.bodies[1].collides_with, ElementsAre("a", "b"));
  EXPECT_EQ(scene.bodies[0].color.g, 0.5);
  EXPECT_DOUBLE_EQ(scene.bodies[1].color.r, 70 / 255.0);
}

TEST(ReadScene, KinematicBodiesStartWhereTheirPathBegins) {
  const Scene scene = parse_scene(
      "object follower\n shape cube(edge=1)\n motion path\n path position leader.position + (1, 0, 0)\n"
      "object leader\n shape cube(edge=1)\n motion path\n path position (t, 0, 0)\n path rotation (0, 0, t)\n"
      "time\n start 2\n end 3\n step 0.1");
  EXPECT_EQ(scene.bodies[1].position_m, Vec3(2, 0, 0));
  EXPECT_EQ(scene.bodies[0].position_m, Vec3(3, 0, 0));
  EXPECT_EQ(scene.bodies[1].euler_rad, Vec3(0, 0, 2));
  EXPECT_EQ(scene.bodies[0].mass_kg, 0);
}

TEST(Time, FramesAreRobustToRounding) {
  const auto frames = [](double start, double end, double step) {
    return Time{start, end, step, {}}.frames();
  };
  EXPECT_EQ(frames(0, 3.3, 0.3), 12u);
  EXPECT_EQ(frames(0, 0.3, 0.1), 4u);  // 0.3/0.1 < 3
  EXPECT_EQ(frames(0, 1, 1.0 / 3), 4u);
  EXPECT_EQ(frames(0, 1, 0.3), 4u);
  EXPECT_EQ(frames(5, 5, 0.1), 1u);
  EXPECT_EQ(frames(-1, 1, 0.5), 5u);
  const Time time{1, 3.3, 0.3, {}};
  EXPECT_EQ(time.frame_times()[7], 1 + 7 * 0.3);
}

TEST(ReadWorld, MethodsAreThoseOfFred) {
  std::vector<std::string> offered;
  for (const fred::Tableau& tableau : fred::tableaus()) offered.push_back(tableau.name);
  EXPECT_THAT(known_methods(), testing::ElementsAreArray(offered));
}

TEST(ReadWorld, SaysWhyTheOtherMethodsOfFredCannotBeUsed) {
  for (const fred::Method& method : fred::methods()) {
    if (method.tableau != nullptr) continue;
    try {
      scene_of("world\n method " + method.name + "\nobject ball\n mass 1\n");
      FAIL() << method.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::refused) << error.what();
    }
  }
}

}  // namespace
}  // namespace animado::controle
