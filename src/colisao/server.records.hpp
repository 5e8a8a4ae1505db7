// Between the records of the protocol and the values of the library.
#pragma once

#include <memory>

#include "colisao/advance.hpp"
#include "colisao/broad_phase.hpp"
#include "colisao/protocol.hpp"

namespace animado::colisao {

// The bodies of a prepare request, as the geometry and the response want them.
struct Prepared {
  Bodies bodies;
  std::vector<Collider> colliders;
  BroadPhase broad_phase;  // of the colliders

  size_t size() const { return colliders.size(); }
  // The contacts of a state of shape (13, bodies): by pair, then by feature.
  std::vector<Contact> contacts(const double* state, double margin_m) const;
  ContactFinder finder() const;  // refers to this
  std::vector<BodyState> states(const double* state) const;
};

// Throws bad_params, bad_shape or refused, with the body's name, for a record that makes no sense.
std::shared_ptr<const Prepared> prepared(const Prepare::Request& request);
// Names the content of the request: equal requests have equal handles on every server.
std::string handle_of(const Prepare::Request& request);

ContactRecord record(const Contact& contact, const Vec3& relative_velocity_m_s);
ImpactRecord record(int a, int b, double time_s, const Contact& contact, const AnsweredImpact& answer);

}  // namespace animado::colisao
