#include "colisao/springs.hpp"

#include <algorithm>
#include <cmath>

#include "colisao/impulse.hpp"

namespace animado::colisao {

SpringForces spring_forces(const Bodies& bodies, const std::vector<BodyState>& states,
                           std::span<const Contact> contacts, double stiffness_N_m, double damping_N_s_m) {
  const size_t count = bodies.size();
  SpringForces result{std::vector<double>(6 * count, 0.0), 0};
  const auto add = [&](int i, const Moving& body, const Vec3& force, const Vec3& point_m) {
    const Vec3 torque = (point_m - body.center_m).cross(force);
    for (size_t row = 0; row < 3; ++row) {
      result.wrenches[row * count + static_cast<size_t>(i)] += force[static_cast<int>(row)];
      result.wrenches[(3 + row) * count + static_cast<size_t>(i)] += torque[static_cast<int>(row)];
    }
  };
  for (const Contact& c : contacts) {
    if (c.gap_m >= 0) continue;
    const size_t ia = static_cast<size_t>(c.a), ib = static_cast<size_t>(c.b);
    const Moving a = moving(bodies[ia], states[ia]), b = moving(bodies[ib], states[ib]);
    const Vec3 u = relative_velocity(a, b, c.point_m);
    const double approach = -u.dot(c.normal);
    const Vec3 slip = u + approach * c.normal;
    const double normal = std::max(0.0, -stiffness_N_m * c.gap_m + damping_N_s_m * approach);
    const double smooth = std::hypot(slip.norm(), bodies.contact_threshold_m_s);
    Vec3 force = normal * c.normal;
    if (smooth > 0) force -= bodies.surface(c.a, c.b).friction * normal / smooth * slip;
    add(c.a, a, force, c.point_m);
    add(c.b, b, -force, c.point_m);
    result.stored_J += stiffness_N_m * c.gap_m * c.gap_m / 2;
  }
  return result;
}

}  // namespace animado::colisao
