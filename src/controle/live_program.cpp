#include "controle/live_program.hpp"

namespace animado::controle {
namespace {

double component(const Quat& q, Member member) {
  switch (member) {
    case Member::qw:
      return q.w();
    case Member::qx:
      return q.x();
    case Member::qy:
      return q.y();
    default:
      assert(member == Member::qz);
      return q.z();
  }
}

Vec3 vector_of(const BodyState& body, Member member) {
  switch (member) {
    case Member::position:
      return body.pose.position_m;
    case Member::velocity:
      return body.velocity_m_s;
    default:
      assert(member == Member::angular_velocity && "the scope makes definitions of what is not in the state");
      return body.angular_velocity_rad_s();
  }
}

bool is_vector(Member member) {
  return type_of(member) == interexpserv::Type::vector;
}

Quat orientation_rate(const BodyState& body) {
  const Vec3& w = body.angular_velocity_body_rad_s;
  Quat rate = body.pose.orientation * Quat(0, w.x(), w.y(), w.z());
  rate.coeffs() *= 0.5;
  return rate;
}

double* put(double* out, const Vec3& v) {
  for (int k = 0; k < 3; ++k) *out++ = v[k];
  return out;
}

}  // namespace

LiveProgram::LiveProgram(const SceneScope& scope, const Expression& expression)
    : program_(scope.compile(expression, interexpserv::Type::vector)) {
  for (const interexpserv::Input& input : program_.inputs()) {
    const auto reading = scope.state_names().find(input.name);
    assert(reading && "an input that the scope let through is in the state");
    readings_.push_back(*reading);
  }
  inputs_.resize(program_.input_count());
  rates_.resize(program_.input_count());
}

void LiveProgram::gather(const Moment& moment) const {
  double* out = inputs_.data();
  for (const Reading& reading : readings_) {
    if (reading.member == Member::time) {
      *out++ = moment.time_s;
      continue;
    }
    const BodyState body = load_body(moment.state, moment.bodies, static_cast<size_t>(reading.body));
    if (is_vector(reading.member)) {
      out = put(out, vector_of(body, reading.member));
    } else {
      *out++ = component(body.pose.orientation, reading.member);
    }
  }
}

void LiveProgram::gather_rates(const Moment& moment) const {
  double* out = rates_.data();
  for (const Reading& reading : readings_) {
    if (reading.member == Member::time) {
      *out++ = 1;
      continue;
    }
    const BodyState body = load_body(moment.state, moment.bodies, static_cast<size_t>(reading.body));
    if (is_vector(reading.member)) {
      out = put(out, reading.member == Member::position ? body.velocity_m_s : Vec3(Vec3::Zero()));
    } else {
      *out++ = component(orientation_rate(body), reading.member);
    }
  }
}

Vec3 LiveProgram::vector(const Moment& moment) const {
  gather(moment);
  Vec3 value;
  program_.evaluate(inputs_.data(), value.data());
  return value;
}

Vec3 LiveProgram::vector_with_rate(const Moment& moment, Vec3& rate) const {
  gather(moment);
  gather_rates(moment);
  Vec3 value;
  program_.evaluate_with_rate(inputs_.data(), rates_.data(), value.data(), rate.data());
  return value;
}

}  // namespace animado::controle
