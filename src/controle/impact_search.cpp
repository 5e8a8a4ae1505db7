#include "controle/impact_search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace animado::controle {
namespace {

// An impact is located where the surfaces are this near: far under what any table shows, far over the
// rounding of metres.
constexpr double kMeetingGap_m = 1e-11;
constexpr double kMeetingMargin_m = 1e-4;  // what is farther apart is no meeting to be closed

// Where the cubic is compared with the dense output: nearly where it errs most, and not in the middle, where
// an error of odd order vanishes.
constexpr double kProbe = 0.4;
constexpr double kMostParts = 16;

using Vec7 = Eigen::Matrix<double, 7, 1>;  // position and quaternion

struct Placement {
  Vec7 value, rate;
};

Placement placement(const Lanes& lanes, size_t bodies, size_t i) {
  const BodyState body = load_body(lanes.values, bodies, i);
  const Vec3& w = body.angular_velocity_body_rad_s;
  Placement p;
  p.value << body.pose.position_m, body.pose.orientation.coeffs();
  p.rate << body.velocity_m_s, 0.5 * (body.pose.orientation * Quat(0, w.x(), w.y(), w.z())).coeffs();
  return p;
}

// The cubic with the values and rates of both ends.
Vec7 cubic(const Placement& from, const Placement& to, double step_s, double s) {
  const double r = 1 - s;
  return r * r * (1 + 2 * s) * from.value + s * s * (3 - 2 * s) * to.value +
         step_s * s * r * (r * from.rate - s * to.rate);
}

}  // namespace

ImpactSearch::ImpactSearch(FreeMotion& motion, colisao::Client& colisao, Meter& meter, size_t bodies,
                           double tolerance)
    : motion_(motion), colisao_(colisao), meter_(meter), bodies_(bodies), tolerance_(tolerance) {
  if (!motion.has_dense_output()) return;
  inside_[0] = motion.make_state("inside_a");
  inside_[1] = motion.make_state("inside_b");
}

colisao::Sweep::Reply ImpactSearch::on_cubic(const Lanes& from, const Lanes& to, double step_s) {
  colisao::Sweep::Request request;
  request.from = from.array;
  request.to = to.array;
  request.step_s = step_s;
  return meter_.timed("colisao", "sweep", [&] { return colisao_.sweep(request); });
}

colisao::Sweep::Reply ImpactSearch::on_dense(const Lanes& from, const Lanes& to, double step_s) {
  const int count = parts(from, to, step_s);
  colisao::Sweep::Reply found;
  const Lanes* start = &from;
  for (int part = 0; part < count && !found.hit; ++part) {
    const Lanes* end = part + 1 == count ? &to : &inside_[part % 2];
    if (end != &to) motion_.dense(static_cast<double>(part + 1) / count, *end);
    found = on_cubic(*start, *end, step_s / count);
    found.time_s += part * step_s / count;
    start = end;
  }
  if (!found.hit) return found;
  found.time_s = close_gap(found, step_s, [&](double at_s) -> const Lanes& {
    motion_.dense(at_s / step_s, inside_[0]);
    return inside_[0];
  });
  return found;
}

// The cubic of a part misses by the fourth power of its length.
int ImpactSearch::parts(const Lanes& from, const Lanes& to, double step_s) {
  const Lanes& inside = inside_[0];
  motion_.dense(kProbe, inside);
  double worst = 0;
  for (size_t i = 0; i < bodies_; ++i) {
    const Vec7 dense = placement(inside, bodies_, i).value;
    const Vec7 missed = cubic(placement(from, bodies_, i), placement(to, bodies_, i), step_s, kProbe) - dense;
    worst = std::max(worst, (missed.array().abs() / (1 + dense.array().abs())).maxCoeff());
  }
  return static_cast<int>(std::ceil(std::clamp(std::pow(worst / tolerance_, 0.25), 1.0, kMostParts)));
}

// How long until the gap of a pair is closed; 0 where it is, or where nothing is known of it.
double ImpactSearch::correction_s(const Lanes& state, int64_t a, int64_t b) {
  colisao::Contacts::Request request;
  request.state = state.array;
  request.margin_m = kMeetingMargin_m;
  const auto reply = meter_.timed("colisao", "contacts", [&] { return colisao_.contacts(request); });
  const colisao::ContactRecord* nearest = nullptr;
  for (const auto& contact : reply.contacts) {
    if (contact.a != a || contact.b != b) continue;
    if (!nearest || contact.gap_m < nearest->gap_m) nearest = &contact;
  }
  if (!nearest || std::abs(nearest->gap_m) < kMeetingGap_m || nearest->approach_m_s <= 0) return 0;
  return nearest->gap_m / nearest->approach_m_s;
}

}  // namespace animado::controle
