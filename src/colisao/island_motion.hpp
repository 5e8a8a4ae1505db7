// Moves one island of bodies in contact through the sub-steps of a step.
//
// A sub-step of length h, from the velocities v₀:
//
//   1. contacts of the pairs at hand, with those that may close within h;
//   2. impacts: approach faster than the contact threshold is answered with restitution (simultaneous.hpp),
//   v₀ → v₀⁺. A bounce is
//      answered at the end of the sub-step that is nearer to its time;
//   3. v₁ = v₀⁺ + h a + M⁻¹Σ Jᵀ P with contacts as constraints (contact_solver.hpp); one that is open by a
//   gap may close: u_n ≥ −gap/h;
//   4. the pose goes on by the mean velocity, x₁ = x₀ + h (v₀⁺ + v₁)/2: exact for constant forces, sliding
//   included;
//   5. bodies that overlap are moved apart; velocities know nothing of it, so that it adds no kinetic energy.
//
// Kinetic energy changes by the work of the accelerations and by Σ P·(u₀⁺ + u₁)/2 of the contacts; the latter
// is booked. So is what the accelerations would have done to a body that was moved out of an overlap: lifted
// against gravity, it gains energy that no contact took.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "colisao/contact.hpp"
#include "colisao/flight.hpp"
#include "colisao/simultaneous.hpp"

namespace animado::colisao {

// Where contacts come from. a < b; appends those of the pair with gap ≤ margin.
using Manifold = std::function<void(int a, const Pose& pose_a, int b, const Pose& pose_b, double margin_m,
                                    std::vector<Contact>& out)>;

struct TimedImpact {
  int a = 0, b = 0;
  double time_s = 0;
  Contact contact;
  AnsweredImpact answer;
};

struct ContactAccount {
  std::vector<TimedImpact> impacts;
  double dissipated_impact_J = 0, dissipated_friction_J = 0, work_of_told_J = 0;
  int contacts = 0;    // of the last sub-step
  int iterations = 0;  // the most of any sub-step
  double residual_m_s = 0;
};

class IslandMotion {
 public:
  // flights: the island's bodies and the immovable ones that they may touch, by body. pairs: bodies whose
  // contacts count.
  IslandMotion(const Bodies& bodies, const Manifold& manifold, std::map<int, Flight> flights,
               std::vector<std::pair<int, int>> pairs);

  void advance(double step_s, int substeps);

  const ContactAccount& account() const { return account_; }
  // Whether a contact ever acted on the body.
  bool touched(int body) const { return touched_[local(body)]; }
  const BodyState& state(int body) const { return flights_[local(body)].state(); }

 private:
  struct Near {
    Meet meet;           // columns of flights_
    size_t pair = 0;     // index into pairs_
    bool waits = false;  // bounces nearer to the end of the sub-step
  };

  size_t local(int body) const { return column_.at(body); }
  std::vector<Near> find(double substep_s) const;
  void answer_impacts(std::vector<Moving>& now, std::vector<Near>& near, double time_s, double substep_s);
  void hold(const std::vector<Moving>& now, std::vector<Moving>& ahead, const std::vector<Near>& near);
  void push_apart(const std::vector<Moving>& from, const std::vector<Moving>& to,
                  const std::vector<Near>& near, double substep_s);
  void touch(const Contact& contact);

  const Bodies& bodies_;
  const Manifold& manifold_;
  std::map<int, size_t> column_;  // of a body in the vectors below
  std::vector<int> body_;
  std::vector<Flight> flights_;
  std::vector<bool> touched_;
  std::vector<std::pair<int, int>> pairs_;
  std::map<std::pair<size_t, int>, Vec3>
      last_;  // impulses of the last sub-step by pair and feature: the solver's guess
  ContactAccount account_;
};

}  // namespace animado::colisao
