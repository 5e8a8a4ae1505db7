#include "colisao/island_motion.hpp"

#include <algorithm>

#include "colisao/impulse.hpp"
#include "colisao/response_tolerances.hpp"

namespace animado::colisao {

IslandMotion::IslandMotion(const Bodies& bodies, const Manifold& manifold, std::map<int, Flight> flights,
                           std::vector<std::pair<int, int>> pairs)
    : bodies_(bodies), manifold_(manifold), touched_(flights.size(), false), pairs_(std::move(pairs)) {
  for (auto& [body, flight] : flights) {
    column_[body] = flights_.size();
    body_.push_back(body);
    flights_.push_back(std::move(flight));
  }
}

void IslandMotion::advance(double step_s, int substeps) {
  const double h = step_s / substeps;
  for (int k = 0; k < substeps; ++k) {
    std::vector<Moving> now, ahead;
    for (const Flight& flight : flights_) now.push_back(flight.now());
    std::vector<Near> near = find(h);
    answer_impacts(now, near, k * h, h);
    for (size_t i = 0; i < flights_.size(); ++i) ahead.push_back(flights_[i].ahead(now[i], h));
    hold(now, ahead, near);
    for (size_t i = 0; i < flights_.size(); ++i) flights_[i].travel(now[i], ahead[i], h);
    push_apart(now, ahead, near, h);
    account_.contacts = static_cast<int>(near.size());
  }
}

std::vector<IslandMotion::Near> IslandMotion::find(double substep_s) const {
  std::vector<Near> all;
  std::vector<Contact> contacts;
  for (size_t p = 0; p < pairs_.size(); ++p) {
    const auto [a, b] = pairs_[p];
    const size_t column_a = local(a), column_b = local(b);
    const Flight &fa = flights_[column_a], &fb = flights_[column_b];
    const double margin_m = kTouch_m + substep_s * closing_bound_m_s(fa, fb, substep_s);
    contacts.clear();
    manifold_(a, fa.pose(), b, fb.pose(), margin_m, contacts);
    for (Contact& contact : contacts) {
      contact.a = static_cast<int>(column_a);
      contact.b = static_cast<int>(column_b);
      all.push_back({{contact, bodies_.surface(a, b), -std::max(contact.gap_m, 0.0) / substep_s}, p, false});
    }
  }
  return all;
}

void IslandMotion::answer_impacts(std::vector<Moving>& now, std::vector<Near>& near, double time_s,
                                  double substep_s) {
  std::vector<Meet> meets;
  for (Near& n : near) {
    const Contact& c = n.meet.contact;
    const Vec3 u = relative_velocity(now[static_cast<size_t>(c.a)], now[static_cast<size_t>(c.b)], c.point_m);
    const double rebound =
        rebound_m_s(u.dot(c.normal), n.meet.surface.restitution, bodies_.contact_threshold_m_s);
    n.waits = rebound > 0 && c.gap_m > -u.dot(c.normal) * substep_s / 2;
    if (!n.waits) meets.push_back(n.meet);
  }
  const SimultaneousResult result = respond_together(now, meets, bodies_.contact_threshold_m_s);
  account_.dissipated_impact_J += result.dissipated_impact_J;
  account_.dissipated_friction_J += result.dissipated_friction_J;
  account_.work_of_told_J += result.work_of_told_J;
  account_.residual_m_s = std::max(account_.residual_m_s, result.residual_m_s);
  for (const AnsweredImpact& impact : result.impacts) {
    const Contact& c = meets[static_cast<size_t>(impact.meet)].contact;
    touch(c);
    if (impact.approach_m_s <= bodies_.contact_threshold_m_s) continue;
    account_.impacts.push_back(
        {body_[static_cast<size_t>(c.a)], body_[static_cast<size_t>(c.b)], time_s, c, impact});
  }
}

void IslandMotion::hold(const std::vector<Moving>& now, std::vector<Moving>& ahead,
                        const std::vector<Near>& near) {
  std::vector<ContactConstraint> constraints;
  std::vector<const Near*> held;
  for (const Near& n : near) {
    if (n.waits) continue;
    const Contact& c = n.meet.contact;
    const auto guess = last_.find({n.pair, c.feature});
    held.push_back(&n);
    constraints.push_back({c.a, c.b, c.point_m, c.normal, n.meet.surface.friction, n.meet.allowed_m_s,
                           guess == last_.end() ? Vec3::Zero() : guess->second});
  }
  const SolverReport report = solve_contacts(ahead, constraints, kSolverTolerance);
  account_.iterations = std::max(account_.iterations, report.iterations);
  account_.residual_m_s = std::max(account_.residual_m_s, report.residual_m_s);
  last_.clear();
  for (size_t n = 0; n < held.size(); ++n) {
    const Vec3& P = constraints[n].impulse_N_s;
    if (P == Vec3::Zero()) continue;
    const Contact& c = held[n]->meet.contact;
    const size_t a = static_cast<size_t>(c.a), b = static_cast<size_t>(c.b);
    const Vec3 mean =
        (relative_velocity(now[a], now[b], c.point_m) + relative_velocity(ahead[a], ahead[b], c.point_m)) / 2;
    const double normal_work = P.dot(c.normal) * mean.dot(c.normal);
    account_.dissipated_impact_J -= normal_work;
    account_.dissipated_friction_J -= P.dot(mean) - normal_work;
    account_.work_of_told_J += work_of_told_J(now[a], now[b], c.point_m, P);
    last_[{held[n]->pair, c.feature}] = P;
    touch(c);
  }
}

// Small displacements obey the same equations as velocities: the solver finds those that open what overlaps
// and close nothing.
void IslandMotion::push_apart(const std::vector<Moving>& from, const std::vector<Moving>& to,
                              const std::vector<Near>& near, double substep_s) {
  std::vector<ContactConstraint> constraints;
  bool overlap = false;
  for (const Near& n : near) {
    if (n.waits) continue;
    const Contact& c = n.meet.contact;
    const size_t a = static_cast<size_t>(c.a), b = static_cast<size_t>(c.b);
    const Vec3 mean =
        (relative_velocity(from[a], from[b], c.point_m) + relative_velocity(to[a], to[b], c.point_m)) / 2;
    const double gap_m = c.gap_m + substep_s * mean.dot(c.normal);
    const double open_m =
        gap_m < -kSlop_m ? std::min(kPushShare * (-gap_m - kSlop_m), kLongestPush_m) : -std::max(gap_m, 0.0);
    overlap = overlap || open_m > 0;
    constraints.push_back({c.a, c.b, c.point_m, c.normal, 0, open_m, Vec3::Zero()});
  }
  if (!overlap) return;

  std::vector<Moving> shifts(to);
  for (Moving& shift : shifts) shift.velocity_m_s = shift.spin_rad_s = Vec3::Zero();
  solve_contacts(shifts, constraints, kPushTolerance);
  for (size_t i = 0; i < flights_.size(); ++i) {
    if (shifts[i].velocity_m_s.isZero(0) && shifts[i].spin_rad_s.isZero(0)) continue;
    account_.dissipated_impact_J += flights_[i].shift(shifts[i].velocity_m_s, shifts[i].spin_rad_s);
    touched_[i] = true;
  }
}

void IslandMotion::touch(const Contact& contact) {
  touched_[static_cast<size_t>(contact.a)] = touched_[static_cast<size_t>(contact.b)] = true;
}

}  // namespace animado::colisao
