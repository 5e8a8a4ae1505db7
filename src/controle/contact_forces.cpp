#include "controle/contact_forces.hpp"

#include "base/state.hpp"

namespace animado::controle {

SpringContacts::SpringContacts(colisao::Client& colisao, Workspace& workspace, Meter& meter,
                               const World& world, std::span<const Inertia> inertias)
    : colisao_(colisao),
      meter_(meter),
      inertias_(inertias.begin(), inertias.end()),
      wrenches_(workspace.make("springs", {6, static_cast<int64_t>(inertias.size())})) {
  request_.stiffness_N_m = world.spring_stiffness_N_m;
  request_.damping_N_s_m = world.spring_damping_N_s_m;
  request_.out = wrenches_.array;
}

colisao::Springs::Reply SpringContacts::springs(const Lanes& state) {
  const auto n = static_cast<int64_t>(inertias_.size());
  request_.state = rpc::Array::named(state.array.shared, {kStateRows, n});
  return meter_.timed("colisao", "springs", [&] { return colisao_.springs(request_); });
}

double SpringContacts::stored_J(const Lanes& state) {
  return springs(state).stored_J;
}

double SpringContacts::add(const Lanes& state, double* wrenches) {
  springs(state);
  const size_t n = inertias_.size();
  double power_W = 0;
  for (size_t i = 0; i < n; ++i) {
    const BodyState body = load_body(state.values, n, i);
    const auto at = [&](size_t row) { return wrenches_.values[row * n + i]; };
    const Vec3 force(at(0), at(1), at(2)), torque(at(3), at(4), at(5));
    const Vec3 v = body.velocity_m_s + body.pose.orientation * body.angular_velocity_body_rad_s.cross(
                                                                   inertias_[i].center_of_mass_m);
    power_W += force.dot(v) + torque.dot(body.angular_velocity_rad_s());
    for (size_t row = 0; row < 6; ++row) wrenches[row * n + i] += at(row);
  }
  return power_W;
}

}  // namespace animado::controle
