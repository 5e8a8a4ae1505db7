// The paper's fifteen linear equations (section 3.4.2) for an impact at one contact point.
//
// Unknowns, in this order: v₁' v₂' ω₁' ω₂' P, three each. Rows:
//
//   v₁' − P/m₁ = v₁,   v₂' + P/m₂ = v₂,   ω₁' − I₁⁻¹(ρ₁×P) = ω₁,   ω₂' + I₂⁻¹(ρ₂×P) = ω₂ (3) and three of the
//   tangential directions i, j and the normal k:
//     frictionless  P·i = P·j = 0                        sticking  u'·i = u'·j = 0
//     sliding       P·i + μ (t̂·i) P·k = 0, the same with j
//     always        u'·k = the rebound, −ε u·k (0 in the paper's inelastic case) (4)
//
// with u' = v₁' + ω₁'×ρ₁ − v₂' − ω₂'×ρ₂. The rows of (3) are divided by mass and inertia, so that an
// immovable body's read v' = v. Which tangential rows hold is the verdict of the closed form (impulse.hpp);
// the numbers are those of the system.
#pragma once

#include <functional>
#include <vector>

#include "colisao/impulse.hpp"

namespace animado::colisao {

// Solves A x = b. A: 15×15, row-major; b: 15. Returns x: 15. What it throws passes through.
using Solve15 = std::function<std::vector<double>(const std::vector<double>& matrix,
                                                  const std::vector<double>& right_side)>;

struct System15 {
  std::vector<double> matrix;      // 15×15, row-major
  std::vector<double> right_side;  // 15
};

System15 system15(const Moving& a, const Moving& b, const Contact& contact, double friction,
                  double rebound_m_s);

// The same answer as point_impulse; the system gives the velocities too, which follow from P by equation (3).
PointImpulse point_impulse_by_system15(const Moving& a, const Moving& b, const Contact& contact,
                                       double friction, double rebound_m_s, const Solve15& solve);

}  // namespace animado::colisao
