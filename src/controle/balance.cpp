#include "controle/balance.hpp"

#include "base/state.hpp"

namespace animado::controle {

Vec3 center_of_mass(const Inertia& inertia, const Pose& pose) {
  return pose.to_world(inertia.center_of_mass_m);
}

Balance balance(const Scene& scene, std::span<const Inertia> inertias, const double* state) {
  Balance sum;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].motion != Motion::dynamic) continue;
    const Inertia& inertia = inertias[i];
    const BodyState body = load_body(state, scene.bodies.size(), i);
    const Vec3& w = body.angular_velocity_body_rad_s;
    const Vec3 x = center_of_mass(inertia, body.pose);
    const Vec3 v = body.velocity_m_s + body.pose.orientation * w.cross(inertia.center_of_mass_m);
    const Vec3 spin = inertia.inertia_kg_m2 * w;
    const Vec3 p = inertia.mass_kg * v;
    sum.kinetic_J += 0.5 * (p.dot(v) + w.dot(spin));
    sum.potential_J -= inertia.mass_kg * scene.world.gravity_m_s2.dot(x);
    sum.linear_momentum_kg_m_s += p;
    sum.angular_momentum_kg_m2_s += x.cross(p) + body.pose.orientation * spin;
  }
  return sum;
}

}  // namespace animado::controle
