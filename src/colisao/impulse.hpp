// The impulse of an impact at one contact point, in closed form.
//
//   m₁v₁' = m₁v₁ + P   I₁ω₁' = I₁ω₁ + ρ₁×P   m₂v₂' = m₂v₂ − P   I₂ω₂' = I₂ω₂ − ρ₂×P     (paper,
//   section 3.4.2, equation 3; [MW88])
//
// make the relative velocity u = v₁ + ω₁×ρ₁ − v₂ − ω₂×ρ₂ of the two points that meet change by u' − u = K P,
// with
//
//   K = (1/m₁ + 1/m₂) 1 − [ρ₁]× I₁⁻¹ [ρ₁]× − [ρ₂]× I₂⁻¹ [ρ₂]×.
//
// Equation (4) of the paper is the inelastic impact without friction: P·i = P·j = 0, u'·k = 0. Here u'·k = −ε
// u·k, and friction is Coulomb's: P first tries to stop the sliding (u'·i = u'·j = 0); where that needs |P_t|
// > μ P_n the impulse is P_n (k − μ t̂), t̂ the direction of sliding before the impact.
//
// Deviation: K couples the directions, so that friction at one point may turn the sliding back and feed
// energy in. It is then held at what stops the sliding along t̂, or (sticking) at the largest share that
// leaves the energy where it was.
#pragma once

#include "colisao/bodies.hpp"
#include "colisao/contact.hpp"

namespace animado::colisao {

// The tangential part of P. given: neither rule in full; P_t is what the energy allows, zero without
// friction.
enum class Friction { sticks, slides, given };

struct PointImpulse {
  Vec3 impulse_N_s = Vec3::Zero();  // P: on a, −P on b; world
  Friction friction = Friction::given;
};

// u: velocity of a's point relative to b's, world. Its part along the normal is negative when they approach.
Vec3 relative_velocity(const Moving& a, const Moving& b, const Vec3& point_m);

// K, world axes. Positive definite when one of the two is movable.
Mat3 inverse_mass_at(const Moving& a, const Moving& b, const Vec3& point_m);

// The work that a body which moves as it is told (kinematic) does on the other one through an impulse P on a;
// 0 between movable or fixed bodies.
double work_of_told_J(const Moving& a, const Moving& b, const Vec3& point_m, const Vec3& impulse_N_s);

// u'·k that restitution asks for: −ε u·k, or 0 when the approach is slower than the contact threshold.
double rebound_m_s(double normal_velocity_m_s, double restitution, double contact_threshold_m_s);

// The impulse that gives the pair the normal velocity `rebound_m_s`; it must be approaching (u·k ≤ rebound).
PointImpulse point_impulse(const Moving& a, const Moving& b, const Contact& contact, double friction,
                           double rebound_m_s);

}  // namespace animado::colisao
