// colisao/sweep.cpp: the first meeting among many bodies.
#include "colisao/sweep.hpp"

#include <gtest/gtest.h>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

struct World {
  std::vector<Collider> bodies;
  std::vector<BodyState> states;

  void add(Shape shape, const BodyState& state, Motion motion = Motion::dynamic) {
    bodies.push_back({Solid(std::move(shape)), motion, {}, {}});
    states.push_back(state);
  }
  SweepResult sweep_free(double step_s) const {
    const size_t n = states.size();
    std::vector<double> from(kStateRows * n), to(kStateRows * n);
    for (size_t i = 0; i < n; ++i) {
      store_body(from.data(), n, i, states[i]);
      store_body(to.data(), n, i, after(states[i], step_s));
    }
    return sweep(bodies, BroadPhase(bodies), from.data(), to.data(), step_s);
  }
};

BodyState moving_at(const Vec3& position, const Vec3& velocity) {
  return moving_body(position, Quat::Identity(), velocity, Vec3::Zero());
}

TEST(Sweep, TheEarliestPairWins) {
  World world;
  world.add(Sphere{0.5}, moving_at({0, 0, 0}, {1, 0, 0}));
  world.add(Sphere{0.5}, moving_at({3, 0, 0}, {0, 0, 0}));     // met by the first at 2 s
  world.add(Sphere{0.5}, moving_at({4.5, 0, 0}, {-1, 0, 0}));  // meets the second at 0.5 s
  const SweepResult r = world.sweep_free(4);
  EXPECT_TRUE(r.hit);
  EXPECT_TRUE(r.near);
  EXPECT_NEAR(r.time_s, 0.5, 1e-12);
  EXPECT_EQ(r.a, 1);
  EXPECT_EQ(r.b, 2);
}

TEST(Sweep, NothingMeetsAndNothingIsNear) {
  World world;
  world.add(Sphere{0.5}, moving_at({0, 0, 0}, {1, 0, 0}));
  world.add(Sphere{0.5}, moving_at({3, 0, 0}, {0, 0, 0}));
  const SweepResult r = world.sweep_free(0.5);
  EXPECT_FALSE(r.hit);
  EXPECT_FALSE(r.near);
  EXPECT_EQ(r.time_s, 0.5);
  EXPECT_EQ(r.a, -1);
  EXPECT_TRUE(world.sweep_free(2 - 1e-4).near);
}

TEST(Sweep, RestingPairsAreLeftAlone) {
  World world;
  world.add(HalfSpace{{0, 1, 0}, 0}, {}, Motion::fixed);
  world.add(Box{{0.5, 0.5, 0.5}}, moving_at({0, 0.5, 0}, {1, 0, 0}));
  const SweepResult r = world.sweep_free(0.1);
  EXPECT_FALSE(r.hit);
  EXPECT_TRUE(r.near);
  EXPECT_FALSE(r.sinking);
  world.states[1].velocity_m_s.y() = -0.01;
  EXPECT_TRUE(world.sweep_free(0.1).sinking);
}

TEST(Sweep, SameBitsAgain) {
  World world;
  Random random(71);
  for (int i = 0; i < 60; ++i) {
    world.add(Box{{0.3, 0.2, 0.4}}, {random.pose(3), random.vector(2), random.vector(5)});
  }
  const SweepResult once = world.sweep_free(0.05), again = world.sweep_free(0.05);
  EXPECT_EQ(once.time_s, again.time_s);
  EXPECT_EQ(once.a, again.a);
  EXPECT_EQ(once.candidates, again.candidates);
}

// Bodies far from each other, each spinning: no pair is even looked at.
TEST(Sweep, ALatticeOfTopsHasNoCandidates) {
  World world;
  Random random(72);
  for (int i = 0; i < 1000; ++i) {
    world.add(Box{{0.5, 0.3, 0.2}}, moving_body({5.0 * (i % 10), 5.0 * (i / 10 % 10), 5.0 * (i / 100)},
                                                Quat::Identity(), Vec3::Zero(), random.vector(5)));
  }
  const SweepResult r = world.sweep_free(1.0 / 60);
  EXPECT_EQ(r.candidates, 0);
  EXPECT_FALSE(r.near);
}

}  // namespace
}  // namespace animado::colisao
