// Steps time (design, section 5): free motion, then contact, then what met on the way, answered at its time.
//
// Two regimes, one rule. An impact is an event: located within the step, everything is brought to its time,
// it is answered there, and the rest of the step is run again from the new velocities. Continuous contact is
// a constraint: colisao advances the islands in contact from the same start and the same accelerations, and
// what touches nothing keeps fred's result. When a step has more events than kMostEventsAStep, it is crowded:
// colisao takes the impacts inside the islands too.
#pragma once

#include <functional>
#include <optional>

#include "base/state.hpp"
#include "colisao/client.hpp"
#include "controle/contact_events.hpp"
#include "controle/contact_forces.hpp"
#include "controle/embedded_steps.hpp"
#include "controle/free_motion.hpp"
#include "controle/impact_search.hpp"
#include "controle/results/ledger.hpp"
#include "controle/scene/scene.hpp"
#include "controle/step_size.hpp"

namespace animado::controle {

struct Counts {
  int64_t steps = 0, impacts = 0, crowded_steps = 0;
};

class Stepper {
 public:
  using Report = ContactEvents::Report;
  using Stop = std::function<bool()>;

  Stepper(const Scene& scene, std::span<const Inertia> inertias, FreeMotion& motion, const Forces& forces,
          colisao::Client& colisao, Meter& meter, Report report);

  // Moves the state to the next frame. `stop` is asked before every step, since a frame may take any number
  // of them; false where it ended the way there.
  bool advance_to(
      double end_s, const Stop& stop = [] { return false; });

  // The forces have changed, so that what they were at the end of the last step is not what they are now.
  void forget_rates();

  double time_s() const { return time_s_; }
  const double* state() const { return now_.values; }
  const Lanes& lanes() const { return now_; }
  const Counts& counts() const { return counts_; }
  int64_t contacts() const { return contacts_; }  // points that touched in the last step

  // The ledger's flows so far; initial and final energies are the caller's.
  const EnergyLedger& flows() const { return flows_; }

 private:
  bool touches() const { return near_ && collides_; }
  void equal_steps(double end_s, size_t steps, const Stop& stop);
  void step(double end_s);
  void go_through_events(double end_s);
  double move(double step_s, bool crowded);
  double move_to_impact(double step_s, const colisao::Sweep::Reply& hit);
  void touch(double step_s, bool crowded);
  void correct_work();
  colisao::Sweep::Reply sweep(double step_s);
  void accept(double end_s);
  template <class Reply>
  void book(const Reply& reply);  // what contacts did to the energy
  void respond();
  void record(const std::vector<colisao::ImpactRecord>& impacts);

  const Scene& scene_;
  std::span<const Inertia> inertias_;
  FreeMotion& motion_;
  const Forces& forces_;
  colisao::Client& colisao_;
  Meter& meter_;
  ContactEvents events_;
  ImpactSearch search_;
  std::optional<StepSize> step_size_;            // equal steps, or
  std::optional<EmbeddedSteps> embedded_steps_;  // each as long as the method's own error lets it be
  size_t bodies_;
  bool collides_;  // impacts and contacts are answered (response spring answers by forces)
  double time_s_;
  Lanes now_, next_, free_;
  colisao::Advance::Reply
      pending_;              // what the last move did to the islands: it counts once the move is accepted
  std::vector<Work> work_;   // of each drive in the last move, likewise
  bool near_ = true;         // bodies are so near that contact is worth asking about
  bool in_contact_ = false;  // the last move had islands in contact
  int64_t contacts_ = 0;     // their contact points
  Counts counts_;
  EnergyLedger flows_;
};

}  // namespace animado::controle
