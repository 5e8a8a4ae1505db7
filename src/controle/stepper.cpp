#include "controle/stepper.hpp"

#include "base/error.hpp"
#include "base/state.hpp"
#include "controle/balance.hpp"

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

// An impact is located where the surfaces are this near: far under what any table shows, far over the
// rounding of metres.
constexpr double kMeetingGap_m = 1e-11;
constexpr int kMostRefinements = 3;

// Pairs nearer than this are said to be in contact; wider than what the contact solver leaves, so that rest
// does not flicker.
constexpr double kContactMargin_m = 1e-5;

constexpr double kSpeedOfLight_m_s = 299792458;  // what is faster has diverged

Vec3 vec3(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

Stepper::Stepper(const Scene& scene, std::span<const Inertia> inertias, FreeMotion& motion,
                 const Forces& forces, colisao::Client& colisao, Meter& meter, Report report)
    : scene_(scene),
      inertias_(inertias),
      motion_(motion),
      forces_(forces),
      colisao_(colisao),
      meter_(meter),
      report_(std::move(report)),
      step_size_(motion, scene.bodies.size(), scene.world.substep_s, scene.world.tolerance),
      bodies_(scene.bodies.size()),
      collides_(scene.bodies.size() > 1 && scene.world.response != Response::spring),
      time_s_(scene.time.start_s),
      now_(motion.make_state("state_a")),
      next_(motion.make_state("state_b")),
      free_(motion.make_state("state_free")) {
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

void Stepper::advance_to(double end_s) {
  if (near_) respond();
  // An impact may change how fast things turn, so the steps are chosen again after each one.
  while (time_s_ < end_s) {
    const double rest_s = end_s - time_s_;
    const double most_s = in_contact_ ? kContactStep_s : rest_s;
    const size_t steps = step_size_.steps(now_, time_s_, rest_s, most_s);
    const int64_t impacts = counts_.impacts;
    const bool was_in_contact = in_contact_;
    for (size_t k = 0; k < steps; ++k) {
      // From the end, so that rounding does not gather and the last step ends where the frame does.
      const double to_s =
          k + 1 == steps ? end_s
                         : end_s - rest_s * static_cast<double>(steps - 1 - k) / static_cast<double>(steps);
      step(to_s);
      if (counts_.impacts != impacts || in_contact_ != was_in_contact) break;
    }
  }
}

// One step: events one after the other until its end.
void Stepper::step(double end_s) {
  ++counts_.steps;
  for (int events = 0; time_s_ < end_s; ++events) {
    const double rest_s = end_s - time_s_;
    const bool crowded = events >= kMostEventsAStep || contacts_ > kHeapContacts;
    move(rest_s, crowded);
    if (!collides_ || crowded) {
      near_ = collides_;
      counts_.crowded_steps += crowded ? 1 : 0;
      return accept(end_s);
    }
    const auto hit = sweep(rest_s);
    near_ = hit.near || hit.hit;
    if (!hit.hit) return accept(end_s);
    const double at_s = move_to_impact(rest_s, hit);
    accept(std::min(end_s, time_s_ + at_s));
    respond();
  }
}

colisao::Sweep::Reply Stepper::sweep(double step_s) {
  colisao::Sweep::Request request;
  request.from = now_.array;
  request.to = next_.array;
  request.step_s = step_s;
  return meter_.timed("colisao", "sweep", [&] { return colisao_.sweep(request); });
}

// now → next, as if nothing met on the way that does not touch now.
void Stepper::move(double step_s, bool crowded) {
  pending_ = {};
  if (!near_ || !collides_) {
    motion_.step(now_, time_s_, step_s, next_);
    work_ = motion_.work();
    return;
  }
  motion_.step(now_, time_s_, step_s, free_);
  work_ = motion_.work();
  colisao::Advance::Request request;
  request.state = now_.array;
  request.free = free_.array;
  request.accelerations = motion_.start_accelerations();
  request.step_s = step_s;
  request.substeps = static_cast<int64_t>(std::ceil(step_s / kContactSubstep_s * (1 - 1e-12)));
  request.crowded = crowded;
  request.out = next_.array;
  pending_ = meter_.timed("colisao", "advance", [&] { return colisao_.advance(request); });
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

// Brings everything to the time at which the pair meets, and returns that time. The dense output is of lower
// order than the method, so the gap that is left is closed by its own speed.
double Stepper::move_to_impact(double step_s, const colisao::Sweep::Reply& hit) {
  double at_s = hit.time_s;
  for (int refinement = 0;; ++refinement) {
    move(at_s, false);
    if (refinement == kMostRefinements) return at_s;
    const auto meeting = nearest_contact(hit.a, hit.b);
    if (!meeting || std::abs(meeting->gap_m) < kMeetingGap_m || meeting->approach_m_s <= 0) return at_s;
    const double corrected_s = at_s + meeting->gap_m / meeting->approach_m_s;
    if (corrected_s <= 0 || corrected_s > step_s || corrected_s == at_s) return at_s;
    at_s = corrected_s;
  }
}

std::optional<colisao::ContactRecord> Stepper::nearest_contact(int64_t a, int64_t b) {
  colisao::Contacts::Request request;
  request.state = next_.array;
  request.margin_m = 1e-4;
  const auto reply = meter_.timed("colisao", "contacts", [&] { return colisao_.contacts(request); });
  std::optional<colisao::ContactRecord> nearest;
  for (const auto& contact : reply.contacts) {
    if (contact.a != a || contact.b != b) continue;
    if (!nearest || contact.gap_m < nearest->gap_m) nearest = contact;
  }
  return nearest;
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
  check_finite();
  if (in_contact_ || !touching_.empty()) follow_contacts();
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
  record(reply.impacts);
  book(reply);
  std::swap(now_, next_);
}

void Stepper::record(const std::vector<colisao::ImpactRecord>& impacts) {
  for (const colisao::ImpactRecord& impact : impacts) {
    Event event;
    event.time_s = time_s_ + impact.time_s;
    event.kind = EventKind::impact;
    event.bodies = names(impact.a, impact.b);
    event.point_m = vec3(impact.point_m);
    event.normal = vec3(impact.normal);
    event.impulse_N_s = vec3(impact.impulse_N_s);
    event.approach_m_s = impact.approach_m_s;
    event.separation_m_s = impact.separation_m_s;
    report_(event);
  }
  counts_.impacts += static_cast<int64_t>(impacts.size());
}

// Says which pairs came to rest on each other, and which parted.
void Stepper::follow_contacts() {
  colisao::Contacts::Request request;
  request.state = now_.array;
  request.margin_m = kContactMargin_m;
  const auto reply = meter_.timed("colisao", "contacts", [&] { return colisao_.contacts(request); });
  std::map<Pair, const colisao::ContactRecord*> found;
  for (const auto& contact : reply.contacts) {
    if (std::abs(contact.approach_m_s) < scene_.world.contact_threshold_m_s)
      found.emplace(Pair{contact.a, contact.b}, &contact);
  }
  std::set<Pair> touching;
  for (const auto& [pair, contact] : found) {
    touching.insert(pair);
    if (touching_.contains(pair)) continue;
    Event event{time_s_, EventKind::contact_begin, names(pair.first, pair.second), {}, {}, {}, {}, {}, {},
                {}};
    event.point_m = vec3(contact->point_m);
    event.normal = vec3(contact->normal);
    report_(event);
  }
  for (const Pair& pair : touching_) {
    if (touching.contains(pair)) continue;
    report_({time_s_, EventKind::contact_end, names(pair.first, pair.second), {}, {}, {}, {}, {}, {}, {}});
  }
  touching_ = std::move(touching);
}

std::vector<std::string> Stepper::names(int64_t a, int64_t b) const {
  return {scene_.bodies[static_cast<size_t>(a)].name, scene_.bodies[static_cast<size_t>(b)].name};
}

void Stepper::check_finite() const {
  for (size_t row = 0; row < kStateRows; ++row) {
    const double most = row >= kVx && row <= kVz ? kSpeedOfLight_m_s : std::numeric_limits<double>::max();
    const double* values = now_.values + row * bodies_;
    int64_t beyond = 0;  // counted, not looked for: several bodies at a time
    for (size_t i = 0; i < bodies_; ++i) beyond += !(std::abs(values[i]) <= most);
    if (beyond == 0) continue;
    const auto at = std::find_if(values, values + bodies_, [&](double v) { return !(std::abs(v) <= most); });
    throw Error(Code::diverged,
                fmt::format("the motion of `{}` diverged at t = {:.9g} s",
                            scene_.bodies[static_cast<size_t>(at - values)].name, time_s_),
                scene_.path,
                "A force that grows with the motion it makes, or a step too long for a stiff spring: look "
                "at the object's "
                "force and torque, or give `world` a smaller `substep`.");
  }
}

}  // namespace animado::controle
