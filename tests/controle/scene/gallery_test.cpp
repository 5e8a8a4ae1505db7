// scenes/: every one is read, says at its top what it shows, and what it says there is what it starts from.
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "controle/scene/scene.hpp"

namespace animado::controle {
namespace {

std::vector<std::string> gallery() {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(ANIMADO_SOURCE_DIR "/scenes")) {
    if (file.path().extension() == ".animado") paths.push_back(file.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

Scene scene_named(const std::string& name) {
  return read_scene(ANIMADO_SOURCE_DIR "/scenes/" + name + ".animado");
}

TEST(Gallery, HoldsThePapersExampleAndAtLeastTenMore) {
  EXPECT_GE(gallery().size(), 11u);
}

TEST(Gallery, EverySceneIsReadAndSaysWhatItShows) {
  for (const std::string& path : gallery()) {
    SCOPED_TRACE(path);
    const Scene scene = read_scene(path);
    EXPECT_TRUE(scene.text.starts_with('#'));
    const bool paper = path.ends_with("/colisao.animado");  // its figures and its text are the paper's
    EXPECT_TRUE(paper || scene.text.find("# Closed form: ") != std::string::npos);
    EXPECT_LE(scene.time.frames(), 400u);
  }
}

TEST(Gallery, OrbitStartsOnAnEllipseOfHalfAxisOne) {
  const Scene scene = scene_named("orbit");
  const Body& planet = scene.bodies[1];
  const double gm = std::numbers::pi * std::numbers::pi, r = planet.position_m.norm();
  EXPECT_NEAR(1 / (2 / r - planet.velocity_m_s.squaredNorm() / gm), 1, 1e-14);
}

TEST(Gallery, GyroscopeStartsInSteadyPrecession) {
  const Body top = scene_named("gyroscope").bodies[0];
  const Vec3 axis = top.orientation * Vec3::UnitY(), w = top.angular_velocity_rad_s;
  EXPECT_NEAR(w.dot(axis), 40, 1e-12);
  // What is left beside the spin about the axis turns the axis about the vertical: axis' = w × axis = W y ×
  // axis.
  const double turn = w.cross(axis).norm() / Vec3::UnitY().cross(axis).norm();
  EXPECT_NEAR(turn, 1.2607, 5e-5);
  const double i1 = 0.005 + 0.5 * 0.01, cosine = std::cos(30 * std::numbers::pi / 180);
  EXPECT_NEAR(turn * (0.01 * 40 - i1 * turn * cosine), 0.5 * 9.81 * 0.1, 1e-12);
}

TEST(Gallery, CratesRestOnTheirSlopes) {
  for (const char* name : {"incline_stick", "incline_slide"}) {
    const Scene scene = scene_named(name);
    const auto& slope = std::get<HalfSpace>(scene.bodies[0].shape);
    const Body& crate = scene.bodies[1];
    EXPECT_NEAR(slope.normal.dot(crate.position_m), 0.2, 1e-15);
    EXPECT_NEAR((crate.orientation * Vec3::UnitY() - slope.normal).norm(), 0, 1e-15);
  }
}

}  // namespace
}  // namespace animado::controle
