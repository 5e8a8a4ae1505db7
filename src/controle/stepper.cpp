#include "controle/stepper.hpp"

#include "base/state.hpp"
#include "controle/balance.hpp"
#include "controle/divergence.hpp"

namespace animado::controle {
namespace {

// Beyond this many impacts a step is not made of events any more: each one costs two runs of the rest of the
// step.
constexpr int kMostEventsAStep = 16;

// So many contact points at once are a heap, where one impact sets off the next for ever.
constexpr int64_t kHeapContacts = 64;

// Islands in contact: the velocity-level solver is of first order in what the contacts do, so its steps are
// short.
constexpr double kContactStep_s = 1.0 / 240;
constexpr double kContactSubstep_s = 1.0 / 480;

}  // namespace

Stepper::Stepper(const Scene& scene, std::span<const Inertia> inertias, FreeMotion& motion,
                 const Forces& forces, colisao::Client& colisao, Meter& meter, Report report)
    : scene_(scene),
      inertias_(inertias),
      motion_(motion),
      forces_(forces),
      colisao_(colisao),
      meter_(meter),
      events_(scene, colisao, meter, std::move(report)),
      search_(motion, colisao, meter, scene.bodies.size(), scene.world.tolerance.value_or(kStepTolerance)),
      bodies_(scene.bodies.size()),
      collides_(scene.bodies.size() > 1 && scene.world.response != Response::spring),
      time_s_(scene.time.start_s),
      now_(motion.make_state("state_a")),
      next_(motion.make_state("state_b")),
      free_(motion.make_state("state_free")) {
  const World& world = scene.world;
  if (motion.is_embedded() && !world.substep_s) {
    embedded_steps_.emplace(motion, world.tolerance.value_or(kStepTolerance));
  } else {
    step_size_.emplace(motion, bodies_, world.substep_s, world.tolerance);
  }
  for (size_t i = 0; i < bodies_; ++i) {
    const Body& body = scene.bodies[i];
    BodyState state;
    state.pose = {body.position_m, body.orientation};
    state.velocity_m_s = body.velocity_m_s;
    state.angular_velocity_body_rad_s = body.orientation.conjugate() * body.angular_velocity_rad_s;
    store_body(now_.values, bodies_, i, state);
  }
  motion_.place_kinematic(now_, time_s_);
}

bool Stepper::advance_to(double end_s, const Stop& stop) {
  if (near_) respond();
  while (time_s_ < end_s && !stop()) {
    const double rest_s = end_s - time_s_;
    const double most_s = in_contact_ ? kContactStep_s : rest_s;
    if (step_size_) {
      equal_steps(end_s, step_size_->steps(now_, time_s_, rest_s, most_s), stop);
    } else {
      const double step_s = embedded_steps_->proposed_s(rest_s, most_s);
      step(step_s < rest_s ? time_s_ + step_s : end_s);
    }
  }
  return time_s_ >= end_s;
}

// An impact may change how fast things turn, so the steps are chosen again after each one.
void Stepper::equal_steps(double end_s, size_t steps, const Stop& stop) {
  const double rest_s = end_s - time_s_;
  const int64_t impacts = counts_.impacts;
  const bool was_in_contact = in_contact_;
  for (size_t k = 0; k < steps; ++k) {
    // From the end, so that rounding does not gather and the last step ends where the frame does.
    const double to_s =
        k + 1 == steps ? end_s
                       : end_s - rest_s * static_cast<double>(steps - 1 - k) / static_cast<double>(steps);
    step(to_s);
    if (counts_.impacts != impacts || in_contact_ != was_in_contact || stop()) break;
  }
}

// One step, until its end or until where the method's error lets it end.
void Stepper::step(double end_s) {
  ++counts_.steps;
  go_through_events(end_s);
  meter_.step_ended(counts_.steps, time_s_);
}

void Stepper::go_through_events(double end_s) {
  for (int events = 0; time_s_ < end_s; ++events) {
    const double rest_s = end_s - time_s_;
    const bool crowded = events >= kMostEventsAStep || contacts_ > kHeapContacts;
    const double step_s = move(rest_s, crowded);
    const double to_s = step_s < rest_s ? time_s_ + step_s : end_s;
    if (!collides_ || crowded) {
      near_ = collides_;
      counts_.crowded_steps += crowded ? 1 : 0;
      return accept(to_s);
    }
    const auto hit = sweep(step_s);
    near_ = hit.near || hit.hit;
    if (!hit.hit) return accept(to_s);
    const double at_s = move_to_impact(step_s, hit);
    accept(std::min(to_s, time_s_ + at_s));
    respond();
  }
}

// What islands did to each other is of first order, and not in the method's dense output.
colisao::Sweep::Reply Stepper::sweep(double step_s) {
  const bool dense = motion_.has_dense_output() && pending_.moved.empty();
  return dense ? search_.on_dense(now_, next_, step_s) : search_.on_cubic(now_, next_, step_s);
}

// now → next, as if nothing met on the way that does not touch now. An embedded method may go less far than
// step_s; returns how far.
double Stepper::move(double step_s, bool crowded) {
  const Lanes& to = touches() ? free_ : next_;
  if (embedded_steps_) {
    step_s = embedded_steps_->step(now_, time_s_, step_s, to);
  } else {
    motion_.step(now_, time_s_, step_s, to);
  }
  touch(step_s, crowded);
  return step_s;
}

// Brings everything to the time at which the pair meets, and returns that time. The gap that is left there is
// closed by its own speed: where the sweep's path is of lower order than the method, it is not nothing.
double Stepper::move_to_impact(double step_s, const colisao::Sweep::Reply& hit) {
  return search_.close_gap(hit, step_s, [&](double at_s) -> const Lanes& {
    const Lanes& to = touches() ? free_ : next_;
    if (embedded_steps_) {
      embedded_steps_->repeat(at_s, to);
    } else {
      motion_.step(now_, time_s_, at_s, to);
    }
    touch(at_s, false);
    return next_;
  });
}

// What the bodies that touch make of the free motion. A motion that has diverged goes no further: now stays
// what a run can still tell.
void Stepper::touch(double step_s, bool crowded) {
  pending_ = {};
  work_ = motion_.work();
  check_state(scene_, (touches() ? free_ : next_).values, time_s_ + step_s);
  if (!touches()) return;
  colisao::Advance::Request request;
  request.state = now_.array;
  request.free = free_.array;
  request.accelerations = motion_.start_accelerations();
  request.step_s = step_s;
  request.substeps = static_cast<int64_t>(std::ceil(step_s / kContactSubstep_s * (1 - 1e-12)));
  request.crowded = crowded;
  request.out = next_.array;
  pending_ = meter_.timed("colisao", "advance", [&] { return colisao_.advance(request); });
  check_state(scene_, next_.values, time_s_ + step_s);
  correct_work();
}

// The free motion's work is not that of a body that a contact held.
void Stepper::correct_work() {
  const Moment start = {now_.values, bodies_, time_s_};
  for (size_t d = 0; d < forces_.driven(); ++d) {
    const size_t i = forces_.body_of(d);
    if (!std::binary_search(pending_.moved.begin(), pending_.moved.end(), static_cast<int64_t>(i))) continue;
    const BodyState from = load_body(now_.values, bodies_, i), to = load_body(next_.values, bodies_, i);
    const Vec3 shift = center_of_mass(inertias_[i], to.pose) - center_of_mass(inertias_[i], from.pose);
    Quat turn = to.pose.orientation * from.pose.orientation.conjugate();
    if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
    const Eigen::AngleAxisd rotation(turn);
    work_[d] = forces_.work(d, start, shift, rotation.angle() * rotation.axis());
  }
}

template <class Reply>
void Stepper::book(const Reply& reply) {
  flows_.work_in_J += reply.kinematic_work_J;
  flows_.dissipated_impacts_J += reply.dissipated_impact_J;
  flows_.dissipated_friction_J += reply.dissipated_friction_J;
}

// next becomes now.
void Stepper::accept(double end_s) {
  record(pending_.impacts);
  if (embedded_steps_) embedded_steps_->goes_on(pending_.moved.empty());
  book(pending_);
  for (const Work& work : work_) {
    flows_.work_in_J += work.done_J;
    flows_.dissipated_damping_J += work.damped_J;
  }
  if (!collides_) flows_.dissipated_impacts_J -= motion_.contact_work_J();
  contacts_ = pending_.contacts;
  in_contact_ = pending_.islands > 0;
  std::swap(now_, next_);
  time_s_ = end_s;
  if (in_contact_ || events_.any_touching()) events_.follow(now_, time_s_);
}

void Stepper::respond() {
  if (!collides_) return;
  colisao::Respond::Request request;
  request.state = now_.array;
  request.response =
      scene_.world.response == Response::system15 ? colisao::Response::system15 : colisao::Response::impulse;
  request.out = next_.array;
  const auto reply = meter_.timed("colisao", "respond", [&] { return colisao_.respond(request); });
  if (reply.impacts.empty()) return;
  check_state(scene_, next_.values, time_s_);
  record(reply.impacts);
  book(reply);
  std::swap(now_, next_);
  forget_rates();
}

void Stepper::forget_rates() {
  if (embedded_steps_) embedded_steps_->goes_on(false);
}

void Stepper::record(const std::vector<colisao::ImpactRecord>& impacts) {
  events_.record(impacts, time_s_);
  counts_.impacts += static_cast<int64_t>(impacts.size());
}

}  // namespace animado::controle
