#include "controle/kinematics.hpp"

#include <gtest/gtest.h>

#include "controle/preparation.hpp"

namespace animado::controle {
namespace {

BodyState placed(const Scene& scene, double time_s) {
  const Kinematics kinematics(paths(scene, SceneScope(scene)));
  std::vector<double> state(kStateRows * scene.bodies.size());
  kinematics.place(state.data(), scene.bodies.size(), time_s);
  return load_body(state.data(), scene.bodies.size(), 0);
}

}  // namespace

// The velocity is the path's exact rate of change.
TEST(Kinematics, FollowsAPathWithItsOwnVelocity) {
  const Scene scene = parse_scene(R"(
object arm
  shape sphere(radius = 1)
  motion path
  path position (cos(2*t), sin(2*t), 3*t^2)
  path rotation (0, 0, 5*t)
time
  end 1
  step 0.5
)");
  const BodyState body = placed(scene, 0.3);
  EXPECT_LT((body.pose.position_m - Vec3(std::cos(0.6), std::sin(0.6), 0.27)).norm(), 1e-15);
  EXPECT_LT((body.velocity_m_s - Vec3(-2 * std::sin(0.6), 2 * std::cos(0.6), 1.8)).norm(), 1e-14);
  EXPECT_LT((body.angular_velocity_rad_s() - Vec3(0, 0, 5)).norm(), 1e-14);
}

// Rates of three angles about fixed axes, against a difference of orientations.
TEST(Kinematics, TurnsWithTheAngularVelocityOfItsAngles) {
  const Scene scene = parse_scene(R"(
object arm
  shape sphere(radius = 1)
  motion path
  path rotation (sin(t), t^2, 2*t)
time
  end 1
  step 0.5
)");
  const double h = 1e-5, t = 0.4;
  const Quat before = placed(scene, t - h).pose.orientation, after = placed(scene, t + h).pose.orientation;
  const Eigen::AngleAxisd turn(after * before.conjugate());
  const Vec3 expected = turn.angle() / (2 * h) * turn.axis();
  EXPECT_LT((placed(scene, t).angular_velocity_rad_s() - expected).norm(),
            1e-8);  // the difference's own error: h² and rounding/h
}

}  // namespace animado::controle
