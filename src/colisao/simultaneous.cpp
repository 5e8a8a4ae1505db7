#include "colisao/simultaneous.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "colisao/impulse.hpp"
#include "colisao/islands.hpp"
#include "colisao/response_tolerances.hpp"

namespace animado::colisao {

namespace {

// What a group of contacts is to become, and what it took.
struct Answer {
  std::vector<Vec3> impulses;
  std::vector<Vec3> before, after;  // relative velocities
  SolverReport report;
};

// Work of the impulses on the bodies: their change of kinetic energy.
double work_J(const Answer& answer) {
  double sum = 0;
  for (size_t n = 0; n < answer.impulses.size(); ++n) {
    sum += answer.impulses[n].dot(answer.before[n] + answer.after[n]) / 2;
  }
  return sum;
}

class Rounds {
 public:
  Rounds(std::span<Moving> bodies, std::span<const Meet> meets, double threshold_m_s,
         const PointResponse& respond)
      : bodies_(bodies), meets_(meets), threshold_(threshold_m_s), respond_(respond), total_(meets.size()) {
    for (size_t n = 0; n < meets.size(); ++n) total_[n].meet = static_cast<int>(n);
    is_movable_.reserve(bodies.size());
    for (const Moving& body : bodies) is_movable_.push_back(body.is_movable());
  }

  SimultaneousResult run() {
    std::vector<int> all(meets_.size());
    for (size_t n = 0; n < all.size(); ++n) all[n] = static_cast<int>(n);
    for (const std::vector<int>& island : groups(all)) {
      if (std::any_of(island.begin(), island.end(), [&](int n) { return excess(n) > threshold_; }))
        settle(island);
    }
    for (AnsweredImpact& impact : total_) {
      if (impact.impulse_N_s == Vec3::Zero()) continue;
      impact.separation_m_s = velocity(impact.meet).dot(meet(impact.meet).contact.normal);
      result_.impacts.push_back(impact);
    }
    return std::move(result_);
  }

 private:
  const Meet& meet(int n) const { return meets_[static_cast<size_t>(n)]; }
  Moving& body(int i) { return bodies_[static_cast<size_t>(i)]; }
  Vec3 velocity(int n) {
    const Contact& c = meet(n).contact;
    return relative_velocity(body(c.a), body(c.b), c.point_m);
  }
  double normal_velocity(int n) { return velocity(n).dot(meet(n).contact.normal); }
  double excess(int n) {
    return meet(n).allowed_m_s - normal_velocity(n);
  }  // approach beyond what is allowed
  double rebound(int n) {
    return std::max(meet(n).allowed_m_s,
                    rebound_m_s(normal_velocity(n), meet(n).surface.restitution, threshold_));
  }

  // Contacts grouped by the bodies that they share, in order.
  std::vector<std::vector<int>> groups(const std::vector<int>& contacts) const {
    std::vector<std::pair<int, int>> links;
    for (int n : contacts) links.emplace_back(meet(n).contact.a, meet(n).contact.b);
    std::vector<std::vector<int>> all;
    for (const Island& island : islands(is_movable_, links)) {
      all.emplace_back();
      for (int link : island.links) all.back().push_back(contacts[static_cast<size_t>(link)]);
    }
    return all;
  }

  void settle(const std::vector<int>& island) {
    double scale = 0;
    for (int n : island) scale = std::max(scale, velocity(n).norm());
    const int most = kRoundsAlways + kRoundsEachContact * static_cast<int>(island.size());
    for (int round = 1;; ++round) {
      std::vector<int> approaching;
      for (int n : island) {
        if (excess(n) > kApproachTolerance * scale) approaching.push_back(n);
      }
      if (approaching.empty()) return;
      result_.rounds = std::max(result_.rounds, round);
      const bool bounces =
          std::any_of(approaching.begin(), approaching.end(), [&](int n) { return rebound(n) > 0; });
      if (!bounces || round == most) return project(island);
      for (const std::vector<int>& group : groups(approaching)) answer(group);
    }
  }

  // The inelastic end: no contact of the island approaches any more.
  void project(const std::vector<int>& island) {
    std::vector<double> targets;
    for (int n : island) targets.push_back(meet(n).allowed_m_s);
    const Answer answer = island.size() == 1 ? one(island[0], targets[0]) : many(island, targets);
    result_.converged = result_.converged && answer.report.converged;
    result_.residual_m_s = std::max(result_.residual_m_s, answer.report.residual_m_s);
    record(island, answer);
  }

  void answer(const std::vector<int>& group) {
    std::vector<double> targets;
    for (int n : group) targets.push_back(rebound(n));
    record(group, group.size() == 1 ? one(group[0], targets[0]) : many(group, targets));
  }

  Answer one(int n, double target) {
    const Meet& m = meet(n);
    Answer answer;
    answer.before = {velocity(n)};
    answer.impulses = {respond_(body(m.contact.a), body(m.contact.b), m.contact, m.surface.friction, target)};
    apply(n, answer.impulses[0]);
    answer.after = {velocity(n)};
    return answer;
  }

  Answer many(const std::vector<int>& group, const std::vector<double>& targets) {
    std::vector<std::pair<int, Moving>> start;
    for (int n : group) {
      for (int i : {meet(n).contact.a, meet(n).contact.b}) start.emplace_back(i, body(i));
    }
    const auto rewind = [&] {
      for (const auto& [i, was] : start) body(i) = was;
    };
    const Answer rough = solved(group, targets, 1);
    if (work_J(rough) <= 0) return rough;
    rewind();
    const Answer smooth = solved(group, targets, 0);
    rewind();
    return blended(group, smooth, rough);
  }

  Answer solved(const std::vector<int>& group, const std::vector<double>& targets, double friction_share) {
    Answer answer;
    std::vector<ContactConstraint> constraints;
    for (size_t n = 0; n < group.size(); ++n) {
      const Meet& m = meet(group[n]);
      answer.before.push_back(velocity(group[n]));
      constraints.push_back({m.contact.a, m.contact.b, m.contact.point_m, m.contact.normal,
                             friction_share * m.surface.friction, targets[n]});
    }
    answer.report = solve_contacts(bodies_, constraints, kImpactTolerance);
    for (size_t n = 0; n < group.size(); ++n) {
      answer.impulses.push_back(constraints[n].impulse_N_s);
      answer.after.push_back(velocity(group[n]));
    }
    return answer;
  }

  // The largest share of friction that gains no energy. Both ends meet the normal targets, and so does what
  // lies between. The work is a parabola in the share: its value at both ends and its slope at the
  // frictionless one are known.
  Answer blended(const std::vector<int>& group, const Answer& smooth, const Answer& rough) {
    double slope = 0;
    for (size_t n = 0; n < group.size(); ++n)
      slope += (rough.impulses[n] - smooth.impulses[n]).dot(smooth.after[n]);
    const double lost = work_J(smooth), bend = work_J(rough) - lost - slope;
    double share = 0;
    if (bend > 0) share = (std::sqrt(std::max(0.0, slope * slope - 4 * bend * lost)) - slope) / (2 * bend);
    share = std::clamp(share, 0.0, 1.0);
    Answer answer = smooth;
    for (size_t n = 0; n < group.size(); ++n) {
      answer.impulses[n] += share * (rough.impulses[n] - smooth.impulses[n]);
      apply(group[n], answer.impulses[n]);
    }
    for (size_t n = 0; n < group.size(); ++n) answer.after[n] = velocity(group[n]);
    return answer;
  }

  void apply(int n, const Vec3& impulse) {
    const Contact& c = meet(n).contact;
    body(c.a).push(impulse, c.point_m);
    body(c.b).push(-impulse, c.point_m);
  }

  void record(const std::vector<int>& group, const Answer& answer) {
    for (size_t n = 0; n < group.size(); ++n) {
      const Vec3& k = meet(group[n]).contact.normal;
      const Vec3 mean = (answer.before[n] + answer.after[n]) / 2;
      const double normal_work = answer.impulses[n].dot(k) * mean.dot(k);
      result_.dissipated_impact_J -= normal_work;
      result_.dissipated_friction_J -= answer.impulses[n].dot(mean) - normal_work;
      const Contact& c = meet(group[n]).contact;
      result_.work_of_told_J += work_of_told_J(body(c.a), body(c.b), c.point_m, answer.impulses[n]);
      AnsweredImpact& total = total_[static_cast<size_t>(group[n])];
      total.impulse_N_s += answer.impulses[n];
      if (answer.impulses[n] != Vec3::Zero())
        total.approach_m_s = std::max(total.approach_m_s, -answer.before[n].dot(k));
    }
  }

  std::span<Moving> bodies_;
  std::span<const Meet> meets_;
  double threshold_;
  const PointResponse& respond_;
  std::vector<bool> is_movable_;
  std::vector<AnsweredImpact> total_;
  SimultaneousResult result_;
};

}  // namespace

PointResponse closed_form() {
  return [](const Moving& a, const Moving& b, const Contact& contact, double friction, double rebound) {
    return point_impulse(a, b, contact, friction, rebound).impulse_N_s;
  };
}

SimultaneousResult respond_together(std::span<Moving> bodies, std::span<const Meet> meets,
                                    double contact_threshold_m_s, const PointResponse& respond) {
  return Rounds(bodies, meets, contact_threshold_m_s, respond).run();
}

}  // namespace animado::colisao
