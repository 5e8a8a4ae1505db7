// A small world for the tests of continuous contact: balls and cubes on the floor y = 0, balls among
// themselves; contacts made by hand.
#pragma once

#include "colisao/advance.hpp"

namespace animado::colisao::testing {

struct FloorWorld {
  struct Solid {
    double radius_m = 0;  // of a ball
    double half_m = 0;    // of a cube
  };

  Bodies bodies;
  std::vector<Solid> solids;
  std::vector<BodyState> states;
  Vec3 gravity_m_s2 = {0, -9.81, 0};
  double time_s = 0;
  double dissipated_J = 0;
  std::vector<TimedImpact> impacts;
  AdvanceResult last;

  FloorWorld() { add(immovable_body(Motion::fixed), {}, {}); }  // body 0: the floor, top at its y

  int add(const Body& body, const Solid& solid, const BodyState& state) {
    bodies.list.push_back(body);
    bodies.list.back().radius_m = solid.radius_m > 0 ? solid.radius_m : std::sqrt(3.0) * solid.half_m;
    solids.push_back(solid);
    states.push_back(state);
    return static_cast<int>(states.size()) - 1;
  }
  int add_ball(double mass_kg, double radius_m, const BodyState& state, double friction, double restitution) {
    Body body = dynamic_body(mass_kg, 0.4 * mass_kg * radius_m * radius_m * Mat3::Identity());
    body.friction = friction;
    body.restitution = restitution;
    return add(body, {radius_m, 0}, state);
  }
  int add_cube(double mass_kg, double half_m, const BodyState& state, double friction, double restitution) {
    Body body = dynamic_body(mass_kg, 2.0 / 3 * mass_kg * half_m * half_m * Mat3::Identity());
    body.friction = friction;
    body.restitution = restitution;
    return add(body, {0, half_m}, state);
  }
  void set_floor(double friction, double restitution) {
    bodies.list[0].friction = friction;
    bodies.list[0].restitution = restitution;
  }
  BodyState& operator[](int i) { return states[static_cast<size_t>(i)]; }

  // Contacts of a body with the floor: its lowest point, or its corners.
  void with_floor(const Pose& floor, int i, const Pose& pose, double margin_m,
                  std::vector<Contact>& out) const {
    const Solid& solid = solids[static_cast<size_t>(i)];
    const double top = floor.position_m.y();
    const auto touch = [&](const Vec3& point, int feature) {
      const double gap = point.y() - top;
      if (gap > margin_m) return;
      out.push_back({0, i, {point.x(), (point.y() + top) / 2, point.z()}, -Vec3::UnitY(), gap, {}, feature});
    };
    if (solid.radius_m > 0) touch(pose.position_m - solid.radius_m * Vec3::UnitY(), 0);
    for (int corner = 0; corner < 8 && solid.half_m > 0; ++corner) {
      touch(pose.to_world(solid.half_m * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)),
            corner);
    }
  }
  void manifold(int a, const Pose& pose_a, int b, const Pose& pose_b, double margin_m,
                std::vector<Contact>& out) const {
    if (a == 0) return with_floor(pose_a, b, pose_b, margin_m, out);
    const double radius_a = solids[static_cast<size_t>(a)].radius_m,
                 radius_b = solids[static_cast<size_t>(b)].radius_m;
    const Vec3 apart = pose_a.position_m - pose_b.position_m;
    const double gap = apart.norm() - radius_a - radius_b;
    if (radius_a == 0 || radius_b == 0 || gap > margin_m) return;
    const Vec3 normal = apart.normalized();
    out.push_back({a, b, pose_b.position_m + (radius_b + gap / 2) * normal, normal, gap, {}, 0});
  }
  ContactFinder finder() const {
    const auto all = [count = static_cast<int>(states.size())] {
      ContactFinder::Pairs pairs;
      for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) pairs.emplace_back(a, b);
      }
      return pairs;
    };
    return {[all](const double*, double) { return all(); },
            [all](const double*, const double*, double, double) { return all(); },
            [this](auto&&... arguments) { manifold(arguments...); }};
  }

  std::vector<double> packed(const std::vector<BodyState>& all) const {
    std::vector<double> state(kStateRows * all.size());
    for (size_t i = 0; i < all.size(); ++i) store_body(state.data(), all.size(), i, all[i]);
    return state;
  }

  // One step under gravity.
  void step(double step_s, int substeps, bool crowded = false) {
    const size_t count = states.size();
    std::vector<BodyState> free = states;
    std::vector<double> accelerations(6 * count, 0.0);
    for (size_t i = 0; i < count; ++i) {
      const Body& body = bodies[i];
      const BodyState& state = states[i];
      if (body.motion == Motion::kinematic) free[i].pose.position_m += step_s * state.velocity_m_s;
      if (!body.is_dynamic()) continue;
      const Vec3 &spin = state.angular_velocity_body_rad_s, &c = body.center_of_mass_m;
      const Vec3 angular = -body.inverse_inertia_1_kg_m2 * spin.cross(body.inertia_kg_m2 * spin);
      const Vec3 linear =
          gravity_m_s2 - state.pose.orientation * (angular.cross(c) + spin.cross(spin.cross(c)));
      for (int row = 0; row < 3; ++row) {
        accelerations[static_cast<size_t>(row) * count + i] = linear[row];
        accelerations[static_cast<size_t>(3 + row) * count + i] = angular[row];
      }
      Flight flight(body, state, linear, angular);
      flight.travel(flight.now(), flight.ahead(flight.now(), step_s), step_s);
      free[i] = flight.state();
    }
    const std::vector<double> from = packed(states), to = packed(free);
    last =
        advance(bodies, finder(), {from.data(), accelerations.data(), to.data(), step_s, substeps, crowded});
    for (size_t i = 0; i < count; ++i) states[i] = load_body(last.state.data(), count, i);
    for (TimedImpact impact : last.account.impacts) {
      impact.time_s += time_s;
      impacts.push_back(impact);
    }
    dissipated_J += last.account.dissipated_impact_J + last.account.dissipated_friction_J;
    time_s += step_s;
  }
  void run(double until_s, double step_s, int substeps, bool crowded = false) {
    const int steps = static_cast<int>(std::lround((until_s - time_s) / step_s));
    for (int n = 0; n < steps; ++n) step(step_s, substeps, crowded);
  }

  double energy_J() const {
    double sum = 0;
    for (size_t i = 0; i < states.size(); ++i) {
      if (!bodies[i].is_dynamic()) continue;
      const Vec3 center = states[i].pose.to_world(bodies[i].center_of_mass_m);
      sum += kinetic_energy_J(bodies[i], states[i]) - bodies[i].mass_kg * gravity_m_s2.dot(center);
    }
    return sum;
  }
};

inline BodyState at(const Vec3& position_m, const Vec3& velocity_m_s = Vec3::Zero(),
                    const Vec3& spin_rad_s = Vec3::Zero()) {
  BodyState state;
  state.pose.position_m = position_m;
  state.velocity_m_s = velocity_m_s;
  state.angular_velocity_body_rad_s = spin_rad_s;
  return state;
}

}  // namespace animado::colisao::testing
