// colisao/time_of_impact.cpp: the first meeting of two moving solids, beside closed forms.
#include "colisao/time_of_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

Path flight(const BodyState& start, double step_s) {
  return Path(start, after(start, step_s), step_s);
}
BodyState resting(const Vec3& position) {
  return moving_body(position, Quat::Identity(), Vec3::Zero(), Vec3::Zero());
}

double gap_at(const Solid& a, const Path& pa, const Solid& b, const Path& pb, double time_s) {
  return gap(a, pa.pose(time_s), b, pb.pose(time_s)).gap_m;
}

TEST(TimeOfImpact, ThePapersExample) {
  // Sphere (radius 1) from y = 3 at −0.5 m/s, cube (edge 1) at 0.7 m/s turning about x at 10 rad/s: above the
  // middle line the section of the cube reaches 0.5/max(|cos|, |sin|) straight up only when the sphere
  // touches an edge; the contact is at the published time.
  const Solid sphere(Sphere{1}), cube(Box{{0.5, 0.5, 0.5}});
  const BodyState s = moving_body({0, 3, 0}, Quat::Identity(), {0, -0.5, 0}, {5, 5, 5});
  const BodyState c = moving_body({0, 0, 0}, Quat::Identity(), {0, 0.7, 0}, {10, 0, 0});
  for (const double step : {1e-3, 1e-2}) {
    double hit = 0;
    for (int k = 0; hit == 0 && k < 3 / step; ++k) {
      const double t = k * step;
      const auto path = [&](const BodyState& b) { return Path(after(b, t), after(b, t + step), step); };
      const Impact impact = time_of_impact(sphere, path(s), cube, path(c), step);
      if (impact.hit) hit = t + impact.time_s;
    }
    // The Hermite interpolant of a turn of 10 rad/s is off by (10 h)⁴/384 of the quaternion: 2.6e-7 rad at
    // 1e-2 s.
    EXPECT_NEAR(hit, 1.141953820, step < 5e-3 ? 1e-9 : 1e-6);
  }
}

TEST(TimeOfImpact, BallsInFlight) {
  const Solid a(Sphere{0.5}), b(Sphere{0.25});
  const Path pa = flight(moving_body({0, 0, 0}, Quat::Identity(), {3, 0, 0}, {1, 2, 3}), 2);
  const Path pb = flight(moving_body({4, 0.6, 0}, Quat::Identity(), {-1, 0, 0}, {0, 0, 9}), 2);
  // (4 − 4 t)² + 0.6² = 0.75²
  const Impact impact = time_of_impact(a, pa, b, pb, 2);
  EXPECT_TRUE(impact.hit);
  EXPECT_NEAR(impact.time_s, (4 - 0.45) / 4, 1e-12);
  const double left = gap_at(a, pa, b, pb, impact.time_s);
  EXPECT_GE(left, -1e-14);
  EXPECT_LE(left, 2e-12);
}

TEST(TimeOfImpact, GrazingPass) {
  const Solid ball(Sphere{0.5});
  const Path still = flight(resting({0, 0, 0}), 1);
  const auto pass = [&](double height) {
    const Path moving = flight(moving_body({-2, height, 0}, Quat::Identity(), {4, 0, 0}, {0, 0, 0}), 1);
    return time_of_impact(ball, moving, ball, still, 1);
  };
  EXPECT_FALSE(pass(1 + 1e-9).hit);
  const Impact touch = pass(1 - 1e-9);
  EXPECT_TRUE(touch.hit);
  EXPECT_NEAR(touch.time_s, (2 - std::sqrt(1 - std::pow(1 - 1e-9, 2))) / 4, 1e-8);
}

TEST(TimeOfImpact, BulletThroughPaper) {
  const Solid bullet(Sphere{0.005}), paper(Box{{1, 1, 5e-5}}), needle(Cylinder{0.001, 0.02});
  const Path still = flight(resting({0, 0, 0}), 1.0 / 60);
  const Path fast =
      flight(moving_body({0.1, 0.2, -7}, Quat::Identity(), {0, 0, 900}, {0, 0, 2000}), 1.0 / 60);
  const Impact hit = time_of_impact(bullet, fast, paper, still, 1.0 / 60);
  EXPECT_TRUE(hit.hit);
  EXPECT_NEAR(hit.time_s, (7 - 0.005 - 5e-5) / 900, 1e-14);
  EXPECT_TRUE(time_of_impact(needle, fast, paper, still, 1.0 / 60).hit);
}

TEST(TimeOfImpact, ProjectileOnAPlaneUnderGravity) {
  const Solid ball(Sphere{0.1}), plane(HalfSpace{{0, 1, 0}, 0});
  const double h = 0.5, g = 9.81;
  const BodyState start = moving_body({0, 1, 0}, Quat::Identity(), {1, 0, 0}, {0, 0, 3});
  BodyState end = after(start, h);
  end.pose.position_m.y() -= 0.5 * g * h * h;
  end.velocity_m_s.y() -= g * h;
  const Impact impact = time_of_impact(plane, flight(resting({0, 0, 0}), h), ball, Path(start, end, h), h);
  EXPECT_TRUE(impact.hit);
  EXPECT_NEAR(impact.time_s, std::sqrt(2 * 0.9 / g), 1e-12);
}

// A cube that spins about z over a plane sinks at 1 m/s: its lowest point is at y − √2/2 · cos(π/4 − angle
// within a quarter turn).
TEST(TimeOfImpact, TumblingBoxOnAPlane) {
  const Solid cube(Box{{0.5, 0.5, 0.5}}), plane(HalfSpace{{0, 1, 0}, 0});
  const double h = 1e-3, spin = 7;
  const BodyState start = moving_body({0, 1.3, 0}, Quat::Identity(), {0, -1, 0}, {0, 0, spin});
  double hit = -1;
  for (int k = 0; hit < 0 && k < 1000; ++k) {
    const Path path(after(start, k * h), after(start, (k + 1) * h), h);
    const Impact impact = time_of_impact(cube, path, plane, flight(resting({0, 0, 0}), h), h);
    if (impact.hit) hit = k * h + impact.time_s;
  }
  const auto height = [&](double t) {
    const double quarter = std::fmod(spin * t, std::numbers::pi / 2);
    return 1.3 - t - std::sqrt(0.5) * std::cos(std::numbers::pi / 4 - quarter);
  };
  double t = 0;
  while (height(t) > 0) t += 1e-4;
  double low = t - 1e-4, high = t;
  for (int k = 0; k < 60; ++k) (height(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  EXPECT_NEAR(hit, low, 1e-11);  // (7e-3)⁴/384 of the turn
}

TEST(TimeOfImpact, TouchingAtTheStartIsNoHitUnlessTheyPart) {
  const Solid ball(Sphere{0.5}), plane(HalfSpace{{0, 1, 0}, 0});
  const double h = 0.1, g = 10;
  const Path ground = flight(resting({0, 0, 0}), h);
  const auto thrown = [&](double speed) {
    const BodyState start = moving_body({0, 0.5, 0}, Quat::Identity(), {0, speed, 0}, {0, 0, 0});
    BodyState end = after(start, h);
    end.pose.position_m.y() -= 0.5 * g * h * h;
    end.velocity_m_s.y() -= g * h;
    return time_of_impact(ball, Path(start, end, h), plane, ground, h);
  };
  const Impact down = thrown(0);
  EXPECT_FALSE(down.hit);
  EXPECT_TRUE(down.sinking);
  for (const double speed : {0.4, 0.1, 0.02}) {
    const Impact back = thrown(speed);
    EXPECT_TRUE(back.hit) << speed;
    EXPECT_NEAR(back.time_s, 2 * speed / g, 1e-10) << speed;
  }
  const Impact away = thrown(2);
  EXPECT_FALSE(away.hit);
  EXPECT_FALSE(away.sinking);
  const Impact rest = time_of_impact(ball, flight(resting({0, 0.5, 0}), h), plane, ground, h);
  EXPECT_FALSE(rest.hit);
  EXPECT_FALSE(rest.sinking);
}

// Whatever the shapes and the tumbling: no gap below zero before the reported time, and a gap of zero then.
TEST(TimeOfImpact, IsTheFirstForEveryPair) {
  const auto all = one_of_each();
  Random random(21);
  int hits = 0;
  for (size_t i = 0; i + 1 < all.size(); ++i) {
    for (size_t j = i; j < all.size(); ++j) {
      const Solid &a = all[i].solid, &b = all[j].solid;
      for (int k = 0; k < 20; ++k) {
        const double h = 0.25;
        BodyState sa = moving_body(random.vector(1) + Vec3(0, 4, 0), random.rotation(),
                                   random.vector(2) + Vec3(0, -12, 0), random.vector(6));
        BodyState sb = moving_body(random.vector(0.5), random.rotation(), random.vector(2), random.vector(6));
        if (b.half_space()) sb = resting({0, 0, 0});
        const Path pa = flight(sa, h), pb = flight(sb, h);
        if (gap_at(a, pa, b, pb, 0) < 0.01) continue;
        const Impact impact = time_of_impact(a, pa, b, pb, h);
        const double until = impact.hit ? impact.time_s : h;
        for (int s = 0; s < 100; ++s) {
          EXPECT_GT(gap_at(a, pa, b, pb, until * s / 100), 0)
              << all[i].name << ' ' << all[j].name << ' ' << k;
        }
        if (!impact.hit) continue;
        ++hits;
        EXPECT_NEAR(gap_at(a, pa, b, pb, impact.time_s), 5e-13, 2e-12)
            << all[i].name << ' ' << all[j].name << ' ' << k;
      }
    }
  }
  EXPECT_GT(hits, 150);
}

}  // namespace
}  // namespace animado::colisao
