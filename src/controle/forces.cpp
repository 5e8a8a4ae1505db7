#include "controle/forces.hpp"

#include "base/error.hpp"
#include "base/state.hpp"

namespace animado::controle {
namespace {

std::vector<const LiveProgram*> programs_of(const std::vector<Drive>& drives) {
  std::vector<const LiveProgram*> all;
  for (const Drive& drive : drives) {
    for (const auto* programs : {&drive.forces, &drive.local_forces, &drive.torques, &drive.local_torques}) {
      for (const LiveProgram& program : *programs) all.push_back(&program);
    }
  }
  return all;
}

}  // namespace

Forces::Forces(const Scene& scene, std::vector<Inertia> inertias, std::vector<Drive> drives)
    : scene_(scene),
      inertias_(std::move(inertias)),
      drives_(std::move(drives)),
      batches_(programs_of(drives_)) {
  for (size_t i = 0; i < inertias_.size(); ++i)
    falling_kg_.push_back(scene.bodies[i].motion == Motion::dynamic ? inertias_[i].mass_kg : 0);
}

void Forces::replace(std::vector<Drive> drives) {
  drives_ = std::move(drives);
  batches_ = ProgramBatches(programs_of(drives_));
}

Vec3 Forces::center_velocity(size_t body, const BodyState& state) const {
  return state.velocity_m_s +
         state.pose.orientation * state.angular_velocity_body_rad_s.cross(inertias_[body].center_of_mass_m);
}

void Forces::refuse(const Body& body, double time_s) const {
  const Place place = !body.forces.empty()   ? body.forces.front().place
                      : body.torques.empty() ? Place{}
                                             : body.torques.front().place;
  throw Error(Code::diverged,
              fmt::format("the force or torque on `{}` is not finite at t = {:.9g} s", body.name, time_s),
              scene_.where(place),
              "Look for a division by zero, a root or a logarithm of a negative number, or a force that "
              "grows with the motion it makes.");
}

template <class Value>
Forces::Load Forces::load(const Drive& drive, const BodyState& body, Value value) const {
  Load sum = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const Quat& q = body.pose.orientation;
  for (const LiveProgram& force : drive.forces) sum.force += value(force);
  for (const LiveProgram& force : drive.local_forces) sum.force += q * value(force);
  for (const LiveProgram& torque : drive.torques) sum.torque += value(torque);
  for (const LiveProgram& torque : drive.local_torques) sum.torque += q * value(torque);
  // Damping takes momentum away at the given rate: F = −d m v of the centre of mass, τ = −d I w.
  const Inertia& inertia = inertias_[drive.body];
  sum.damping_force = -drive.linear_damping_1_s * inertia.mass_kg * center_velocity(drive.body, body);
  const Vec3 spin = inertia.inertia_kg_m2 * body.angular_velocity_body_rad_s;
  sum.damping_torque = q * Vec3(-drive.angular_damping_1_s * spin);
  return sum;
}

void Forces::evaluate(const Moment& moment, double* wrenches, Power* powers) const {
  const size_t n = moment.bodies;
  for (size_t k = 0; k < 3; ++k) {
    const double g = scene_.world.gravity_m_s2[static_cast<int>(k)];
    for (size_t i = 0; i < n; ++i) wrenches[k * n + i] = falling_kg_[i] * g;
  }
  std::fill(wrenches + 3 * n, wrenches + 6 * n, 0.0);
  batches_.evaluate(moment);
  size_t program = 0;
  for (size_t d = 0; d < drives_.size(); ++d) {
    const size_t i = drives_[d].body;
    const BodyState body = load_body(moment.state, n, i);
    const Load sum = load(drives_[d], body, [&](const LiveProgram&) { return batches_.value(program++); });
    const Vec3 force = sum.force + sum.damping_force, torque = sum.torque + sum.damping_torque;
    if (!force.allFinite() || !torque.allFinite()) refuse(scene_.bodies[i], moment.time_s);
    for (size_t k = 0; k < 3; ++k) {
      wrenches[k * n + i] += force[static_cast<int>(k)];
      wrenches[(3 + k) * n + i] += torque[static_cast<int>(k)];
    }
    const Vec3 v = center_velocity(i, body), w = body.angular_velocity_rad_s();
    powers[d] = {sum.force.dot(v) + sum.torque.dot(w),
                 -(sum.damping_force.dot(v) + sum.damping_torque.dot(w))};
  }
}

Work Forces::work(size_t drive, const Moment& start, const Vec3& center_displacement_m,
                  const Vec3& rotation_rad) const {
  const BodyState body = load_body(start.state, start.bodies, drives_[drive].body);
  const Load sum =
      load(drives_[drive], body, [&](const LiveProgram& program) { return program.vector(start); });
  return {sum.force.dot(center_displacement_m) + sum.torque.dot(rotation_rad),
          -(sum.damping_force.dot(center_displacement_m) + sum.damping_torque.dot(rotation_rad))};
}

}  // namespace animado::controle
