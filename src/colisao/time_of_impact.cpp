// Conservative advancement of the second order.
//
// Between two moving solids that are apart stands a plane with normal n. A point ρ of A (from the origin of
// its frame) has at τ later the height
//   n · x(t+τ) ≥ n · p + τ n · v + (n + τ n × ω) · ρ − ½ a τ²,
// where a bounds the acceleration of every point, so that the separation along n is at least
//   f(τ) = n · (p_A − p_B) + τ n · (v_A − v_B) − h_A(−n − τ n × ω_A) − h_B(n + τ n × ω_B) − ½ (a_A + a_B) τ²
// with the support functions h. f is concave and f(0) is the gap: nothing can meet before its root. Advancing
// to the root and finding the next n there converges quadratically to the first contact, always from the side
// where the gap is positive. (Conservative advancement: Mirtich, "Impulse-based dynamic simulation of rigid
// body systems", 1996, section 2.3; the support function in τ is the deviation.)
#include "colisao/time_of_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "colisao/distance.hpp"

namespace animado::colisao {
namespace {

constexpr double kMet_m = 1e-12;     // a gap as small as rounding lets it be found
constexpr int kMostAdvances = 2000;  // a grazing pass takes some thirty
constexpr double kShort = 0.9995;    // stops before a root, where rounding could not tell the sides apart
constexpr double kMissing = 1e-7;    // of the size
constexpr double kSampleRatio = 4;   // a flight between two contacts holds one of the samples

// Solid and motion of one of the pair.
struct Mover {
  const Solid& solid;
  const Path& path;

  double reach_m() const { return solid.half_space() ? 0 : solid.radius_m(); }
  double speed_m_s() const { return path.speed_m_s() + path.angular_speed_rad_s() * reach_m(); }
  double acceleration_m_s2() const {
    const double spin = path.angular_speed_rad_s();
    return path.acceleration_m_s2() + (path.angular_acceleration_rad_s2() + spin * spin) * reach_m();
  }
  // Support function about the origin of the frame, world axes.
  double reach_along(const Pose& pose, const Vec3& direction) const {
    if (const HalfSpace* h = solid.half_space()) return h->offset_m;
    const Vec3 d = pose.orientation.conjugate() * direction;
    return d.dot(solid.support(d));
  }
};

class Approach {
 public:
  Approach(const Mover& a, const Mover& b, double until_s)
      : a_(a),
        b_(b),
        until_s_(until_s),
        speed_m_s_(a.speed_m_s() + b.speed_m_s()),
        acceleration_m_s2_(a.acceleration_m_s2() + b.acceleration_m_s2()) {}

  Gap gap_at(double time_s) const {
    return gap(a_.solid, a_.path.pose(time_s), b_.solid, b_.path.pose(time_s));
  }

  // From a time at which the pair is apart.
  Impact meet(double time_s) const {
    for (int k = 0; k < kMostAdvances; ++k) {
      const Gap g = gap_at(time_s);
      if (time_s >= until_s_) return {g.gap_m <= 0, false, until_s_, g.gap_m};
      if (g.gap_m <= met_m(time_s)) return {true, false, time_s, g.gap_m};
      double next = time_s + safe_advance(time_s, g);
      if (next == time_s) next = std::nextafter(time_s, until_s_);
      if (next < until_s_) {
        time_s = next;
        continue;
      }
      time_s = until_s_;
    }
    // Never seen: so many advances leave no motion between the two that could be told from rounding.
    return {true, false, time_s, gap_at(time_s).gap_m};
  }

  // From a start at which the pair touches: whether it parts and meets again.
  Impact meet_again() const {
    double time_s = speed_m_s_ > 0 ? std::min(until_s_, 2 * kParted_m / speed_m_s_) : until_s_;
    while (true) {
      const Gap g = gap_at(time_s);
      if (g.gap_m > kParted_m) return meet(time_s);
      if (g.gap_m < -kSinking_m) return {false, true, until_s_, g.gap_m};
      if (time_s >= until_s_) return {false, false, until_s_, g.gap_m};
      time_s = std::min(until_s_, kSampleRatio * time_s);
    }
  }

 private:
  double met_m(double time_s) const {
    const double far =
        std::max(a_.path.pose(time_s).position_m.norm(), b_.path.pose(time_s).position_m.norm());
    return kMet_m + 8 * std::numeric_limits<double>::epsilon() * (far + a_.reach_m() + b_.reach_m());
  }

  // A τ before which the pair cannot meet: nearly the root of f, from below.
  double safe_advance(double time_s, const Gap& g) const {
    const BodyState at_a = a_.path.state(time_s), at_b = b_.path.state(time_s);
    const Vec3& n = g.normal;
    const Vec3 turn_a = n.cross(at_a.angular_velocity_rad_s()),
               turn_b = n.cross(at_b.angular_velocity_rad_s());
    const double apart = n.dot(at_a.pose.position_m - at_b.pose.position_m);
    const double parting = n.dot(at_a.velocity_m_s - at_b.velocity_m_s);
    const auto f = [&](double tau) {
      return apart + tau * parting - a_.reach_along(at_a.pose, -n - tau * turn_a) -
             b_.reach_along(at_b.pose, n + tau * turn_b) - 0.5 * acceleration_m_s2_ * tau * tau;
    };
    // Where edges meet, a normal known to 1e-8 separates by that much less than the gap: a constant of f,
    // with no part in the motion. A normal that misses more is not trusted with it.
    const double missing = std::min(g.gap_m - f(0), kMissing * (a_.reach_m() + b_.reach_m()));
    double low = 0, high = until_s_ - time_s, f_low = f(0) + missing, f_high = f(high) + missing;
    if (f_high > 0 && f_low > 0) return high;
    // The chord of a concave function meets zero before the function does.
    for (int k = 0; k < 20 && f_low > 1e-3 * g.gap_m && f_high <= 0; ++k) {
      const double chord = low + kShort * (high - low) * f_low / (f_low - f_high);
      for (const double tau : {chord, 0.5 * (chord + high)}) {
        const double value = f(tau) + missing;
        if (value > 0 && tau > low) {
          low = tau;
          f_low = value;
        } else if (value <= 0 && tau < high) {
          high = tau;
          f_high = value;
        }
      }
    }
    return std::max(low, g.gap_m / speed_m_s_);
  }

  const Mover &a_, &b_;
  double until_s_, speed_m_s_, acceleration_m_s2_;
};

// A lower bound of the gap all the way, from the bounding balls; cheap, and enough for most pairs.
double far_apart(const Mover& a, const Mover& b, double until_s) {
  const Pose at_a = a.path.pose(0), at_b = b.path.pose(0);
  const double travel = (a.path.speed_m_s() + b.path.speed_m_s()) * until_s;
  if (const HalfSpace* h = b.solid.half_space()) {
    return (at_b.orientation * h->normal).dot(at_a.position_m - at_b.position_m) - h->offset_m - a.reach_m() -
           travel;
  }
  return (at_a.position_m - at_b.position_m).norm() - a.reach_m() - b.reach_m() - travel;
}

}  // namespace

Impact time_of_impact(const Solid& a, const Path& path_a, const Solid& b, const Path& path_b,
                      double until_s) {
  if (a.half_space() && b.half_space())
    return {false, false, until_s, std::numeric_limits<double>::infinity()};
  if (a.half_space()) return time_of_impact(b, path_b, a, path_a, until_s);
  const Mover mover_a{a, path_a}, mover_b{b, path_b};
  const double apart = far_apart(mover_a, mover_b, until_s);
  if (apart > kTouching_m) return {false, false, until_s, apart};
  const Approach approach(mover_a, mover_b, until_s);
  return approach.gap_at(0).gap_m <= kTouching_m ? approach.meet_again() : approach.meet(0);
}

}  // namespace animado::colisao
