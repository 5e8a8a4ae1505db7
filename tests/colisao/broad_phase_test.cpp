// colisao/broad_phase.cpp: no pair that could meet is lost, and few others are named.
#include "colisao/broad_phase.hpp"

#include <gtest/gtest.h>

#include <set>

#include "geometry_fixtures.hpp"

namespace animado::colisao {
namespace {

std::vector<double> lay_out(const std::vector<BodyState>& bodies) {
  std::vector<double> state(kStateRows * bodies.size());
  for (size_t i = 0; i < bodies.size(); ++i) store_body(state.data(), bodies.size(), i, bodies[i]);
  return state;
}

TEST(BroadPhase, NamesEveryPairOfBallsThatMeets) {
  Random random(51);
  std::vector<Collider> bodies;
  std::vector<BodyState> states;
  for (int i = 0; i < 400; ++i) {
    const double radius = i % 50 == 0 ? 5 : random.uniform(0.2, 0.6);
    bodies.push_back({Solid(Sphere{radius}), i % 7 ? Motion::dynamic : Motion::kinematic, {}, {}});
    states.push_back({random.pose(12), random.vector(30), random.vector(5)});
  }
  const double h = 1.0 / 60;
  std::vector<BodyState> later;
  for (const BodyState& s : states) later.push_back(after(s, h));
  const auto pairs = BroadPhase(bodies).pairs_between(lay_out(states).data(), lay_out(later).data(), h, 0.01);
  const std::set<Pair> named(pairs.begin(), pairs.end());
  EXPECT_EQ(named.size(), pairs.size());
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  size_t near = 0;
  for (int i = 0; i < 400; ++i) {
    for (int j = i + 1; j < 400; ++j) {
      const auto si = static_cast<size_t>(i), sj = static_cast<size_t>(j);
      const double reach = bodies[si].solid.radius_m() + bodies[sj].solid.radius_m() + 0.01;
      bool meets = false;
      for (double t = 0; t <= h; t += h / 8) {
        meets = meets ||
                (after(states[si], t).pose.position_m - after(states[sj], t).pose.position_m).norm() <= reach;
      }
      meets = meets && (i % 7 || j % 7);
      near += meets ? 1 : 0;
      EXPECT_TRUE(!meets || named.count({i, j})) << i << " " << j;
    }
  }
  EXPECT_GT(near, 100u);
  EXPECT_LT(named.size(), 4 * near);
}

TEST(BroadPhase, ABodyThatSpinsInPlaceKeepsItsBox) {
  const std::vector<Collider> bodies{{Solid(Box{{1, 0.1, 0.1}}), {}, {}, {}},
                                     {Solid(Box{{1, 0.1, 0.1}}), {}, {}, {}}};
  const BodyState left{{{0, 0, 0}, Quat::Identity()}, Vec3::Zero(), {0, 900, 700}};
  const BodyState right{{{2.2, 0, 0}, Quat::Identity()}, Vec3::Zero(), {500, 0, 300}};
  const auto from = lay_out({left, right}), to = lay_out({after(left, 0.1), after(right, 0.1)});
  EXPECT_TRUE(BroadPhase(bodies).pairs_between(from.data(), to.data(), 0.1, 0.01).empty());
}

TEST(BroadPhase, LongFloorsAndPlanesNameOnlyWhatIsNear) {
  std::vector<Collider> bodies{{Solid(Box{{50, 1, 50}}), Motion::fixed, {}, {}},
                               {Solid(HalfSpace{{0, 1, 0}, -9}), Motion::fixed, {}, {}}};
  std::vector<BodyState> states{{{{0, -1, 0}, Quat::Identity()}, Vec3::Zero(), Vec3::Zero()}, {}};
  for (const double y : {0.9, 20.0, -8.5}) {
    bodies.push_back({Solid(Sphere{1}), Motion::dynamic, {}, {}});
    states.push_back({{{y < 0 ? 60.0 : 0.0, y, 0}, Quat::Identity()}, Vec3::Zero(), Vec3::Zero()});
  }
  EXPECT_EQ(BroadPhase(bodies).pairs_at(lay_out(states).data(), 0.01), (std::vector<Pair>{{0, 2}, {1, 4}}));
}

TEST(BroadPhase, GroupsMustAllowEachOther) {
  const auto body = [](std::string group, std::vector<std::string> with) {
    return Collider{Solid(Sphere{1}), Motion::dynamic, std::move(group), std::move(with)};
  };
  EXPECT_TRUE(may_meet(body("a", {}), body("", {})));
  EXPECT_TRUE(may_meet(body("a", {"b"}), body("b", {"a", "c"})));
  EXPECT_FALSE(may_meet(body("a", {"b"}), body("b", {"c"})));
  EXPECT_FALSE(may_meet(body("a", {"b"}), body("", {})));
  Collider fixed = body("", {}), moved = body("", {});
  fixed.motion = Motion::fixed;
  moved.motion = Motion::kinematic;
  EXPECT_FALSE(may_meet(fixed, moved));
  EXPECT_TRUE(may_meet(moved, body("", {})));
}

}  // namespace
}  // namespace animado::colisao
