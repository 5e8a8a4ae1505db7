// Equation (1) of the paper (section 2, [WIL90]), all in body axes:
//
//     f = m a − m c × ẇ + m w × (w × c)
//     τ = J ẇ + m c × a + w × J w
//
// with m mass, c centre of mass in the body frame, J inertia tensor about the frame's origin, w angular
// velocity, a acceleration of the frame's origin, f force, τ torque about the origin. As a linear system in
// (a, ẇ) its matrix is constant for each body:
//
//     | m 1       −m [c]× | | a |   | f − m w × (w × c) |
//     | m [c]×     J      | | ẇ | = | τ − w × J w       |
//
// The motion then follows from  p' = v,  q' = ½ q ∘ (0, w),  v' = R a,  w' = ẇ.
//
// Arrays are lanes (rows of N numbers, base/state.hpp), so that each loop below is one pass that the compiler
// turns into vector instructions; every lane keeps its own order of operations, so that the width changes no
// bit.
#pragma once

#include <span>
#include <vector>

#include "base/spatial.hpp"

namespace animado::controle {

// What equation (1) needs to know of a body.
struct Inertia {
  double mass_kg = 1;
  Vec3 center_of_mass_m = Vec3::Zero();   // body frame
  Mat3 inertia_kg_m2 = Mat3::Identity();  // about the centre of mass, body axes
};

class EquationsOfMotion {
 public:
  explicit EquationsOfMotion(std::span<const Inertia> bodies);

  size_t bodies() const { return bodies_; }

  // The constant matrices, (6, 6, N).
  void matrices(double* out) const;

  // Right-hand sides (6, N) for a state (13, N) under wrenches (6, N): force through the centre of mass and
  // torque about it, world.
  void right_sides(const double* state, const double* wrenches, double* out) const;

  // Completes the state's rate of change (13, N), whose last six rows hold a and ẇ in body axes: a is turned
  // to the world's.
  void complete_rates(const double* state, double* rates) const;

 private:
  size_t bodies_;
  std::vector<double> mass_, center_, inertia_;  // (N), (3, N), (6, N): xx yy zz xy xz yz, about the origin
};

}  // namespace animado::controle
