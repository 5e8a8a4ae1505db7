#include "controle/forces.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/state.hpp"

namespace animado::controle {

Forces::Forces(const Scene& scene, std::vector<Inertia> inertias, std::vector<Drive> drives)
    : scene_(scene), inertias_(std::move(inertias)), drives_(std::move(drives)), expressions_(drives_) {
  const size_t n = inertias_.size();
  pushes_.resize(6 * n);
  work_rates_W_.resize(n);
  centers_m_.resize(3 * n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < 3; ++k) centers_m_[k * n + i] = inertias_[i].center_of_mass_m[static_cast<int>(k)];
  }
  for (size_t i = 0; i < n; ++i)
    falling_kg_.push_back(scene.bodies[i].motion == Motion::dynamic ? inertias_[i].mass_kg : 0);
}

void Forces::replace(std::vector<Drive> drives) {
  drives_ = std::move(drives);
  expressions_ = Pushes(drives_);
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

// Damping takes momentum away at the given rate: F = −d m v of the centre of mass, τ = −d I w.
Forces::Load Forces::damping(const Drive& drive, const BodyState& body) const {
  const Inertia& inertia = inertias_[drive.body];
  const Vec3 spin = inertia.inertia_kg_m2 * body.angular_velocity_body_rad_s;
  return {-drive.linear_damping_1_s * inertia.mass_kg * center_velocity(drive.body, body),
          body.pose.orientation * Vec3(-drive.angular_damping_1_s * spin)};
}

void Forces::evaluate(const Moment& moment, double* wrenches, Power* powers) const {
  const size_t n = moment.bodies;
  expressions_.evaluate(moment, pushes_.data());
  for (size_t k = 0; k < 3; ++k) {
    const double g = scene_.world.gravity_m_s2[static_cast<int>(k)];
    for (size_t i = 0; i < n; ++i) wrenches[k * n + i] = falling_kg_[i] * g + pushes_[k * n + i];
  }
  for (size_t e = 3 * n; e < 6 * n; ++e) wrenches[e] = 0.0 + pushes_[e];  // no −0
  if (drives_.empty()) return;
  work_rates(moment);
  for (size_t d = 0; d < drives_.size(); ++d) {
    powers[d] = drives_[d].is_damped() ? damp(drives_[d], moment, wrenches) : Power{};
    powers[d].work_W = work_rates_W_[drives_[d].body];
  }
  check_finite(moment, wrenches);
}

// Adds the damping of a body to its wrench; returns its power.
Power Forces::damp(const Drive& drive, const Moment& moment, double* wrenches) const {
  const size_t n = moment.bodies, i = drive.body;
  const BodyState body = load_body(moment.state, n, i);
  const Load damped = damping(drive, body);
  for (size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const double weight = falling_kg_[i] * scene_.world.gravity_m_s2[axis];
    wrenches[k * n + i] = weight + (pushes_[k * n + i] + damped.force[axis]);
    wrenches[(3 + k) * n + i] = 0.0 + (pushes_[(3 + k) * n + i] + damped.torque[axis]);
  }
  return {0,
          -(damped.force.dot(center_velocity(i, body)) + damped.torque.dot(body.angular_velocity_rad_s()))};
}

void Forces::check_finite(const Moment& moment, const double* wrenches) const {
  const size_t n = moment.bodies;
  if (all_finite({wrenches, 6 * n})) return;
  for (const Drive& drive : drives_) {
    for (size_t k = 0; k < 6; ++k) {
      if (!std::isfinite(wrenches[k * n + drive.body])) refuse(scene_.bodies[drive.body], moment.time_s);
    }
  }
}

// F · (v + R (w × c)) + τ · R w of every body, with R x = x + 2 q_w (q × x) + 2 q × (q × x).
void Forces::work_rates(const Moment& moment) const {
  const size_t n = moment.bodies;
  const double* const q = moment.state + kQw * n;
  const double* const v = moment.state + kVx * n;
  const double* const w = moment.state + kWx * n;
  const double* const c = centers_m_.data();
  const double* const push = pushes_.data();
  double* const out = work_rates_W_.data();
  struct Triple {
    double x, y, z;
  };
  const auto cross = [](Triple a, Triple b) {
    return Triple{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const auto dot = [](Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
#pragma GCC ivdep
  for (size_t i = 0; i < n; ++i) {
    const auto at = [&](const double* rows) { return Triple{rows[i], rows[n + i], rows[2 * n + i]}; };
    const double qw = q[i];
    const Triple qv = at(q + n);
    const auto rotated = [&](Triple x) {
      const Triple half = cross(qv, x), uv = {half.x + half.x, half.y + half.y, half.z + half.z};
      const Triple turn = cross(qv, uv);
      return Triple{x.x + qw * uv.x + turn.x, x.y + qw * uv.y + turn.y, x.z + qw * uv.z + turn.z};
    };
    const Triple spin = at(w), frame = at(v), about = rotated(cross(spin, at(c)));
    const Triple center = {frame.x + about.x, frame.y + about.y, frame.z + about.z};
    out[i] = dot(at(push), center) + dot(at(push + 3 * n), rotated(spin));
  }
}

Work Forces::work(size_t d, const Moment& start, const Vec3& center_displacement_m,
                  const Vec3& rotation_rad) const {
  const Drive& drive = drives_[d];
  const BodyState body = load_body(start.state, start.bodies, drive.body);
  const Quat& q = body.pose.orientation;
  Load push = {Vec3::Zero(), Vec3::Zero()};
  for (const LiveProgram& force : drive.forces) push.force += force.vector(start);
  for (const LiveProgram& force : drive.local_forces) push.force += q * force.vector(start);
  for (const LiveProgram& torque : drive.torques) push.torque += torque.vector(start);
  for (const LiveProgram& torque : drive.local_torques) push.torque += q * torque.vector(start);
  const Load damped = damping(drive, body);
  return {push.force.dot(center_displacement_m) + push.torque.dot(rotation_rad),
          -(damped.force.dot(center_displacement_m) + damped.torque.dot(rotation_rad))};
}

}  // namespace animado::controle
