#include "controle/contact_events.hpp"

#include <map>

namespace animado::controle {
namespace {

// Pairs nearer than this are said to be in contact; wider than what the contact solver leaves, so that rest
// does not flicker.
constexpr double kContactMargin_m = 1e-5;

Vec3 vec3(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

void ContactEvents::record(const std::vector<colisao::ImpactRecord>& impacts, double time_s) {
  for (const colisao::ImpactRecord& impact : impacts) {
    Event event;
    event.time_s = time_s + impact.time_s;
    event.kind = EventKind::impact;
    event.bodies = names(impact.a, impact.b);
    event.point_m = vec3(impact.point_m);
    event.normal = vec3(impact.normal);
    event.impulse_N_s = vec3(impact.impulse_N_s);
    event.approach_m_s = impact.approach_m_s;
    event.separation_m_s = impact.separation_m_s;
    report_(event);
  }
}

void ContactEvents::follow(const Lanes& state, double time_s) {
  colisao::Contacts::Request request;
  request.state = state.array;
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
    Event event{time_s, EventKind::contact_begin, names(pair.first, pair.second), {}, {}, {}, {}, {}, {}, {}};
    event.point_m = vec3(contact->point_m);
    event.normal = vec3(contact->normal);
    report_(event);
  }
  for (const Pair& pair : touching_) {
    if (touching.contains(pair)) continue;
    report_({time_s, EventKind::contact_end, names(pair.first, pair.second), {}, {}, {}, {}, {}, {}, {}});
  }
  touching_ = std::move(touching);
}

std::vector<std::string> ContactEvents::names(int64_t a, int64_t b) const {
  return {scene_.bodies[static_cast<size_t>(a)].name, scene_.bodies[static_cast<size_t>(b)].name};
}

}  // namespace animado::controle
