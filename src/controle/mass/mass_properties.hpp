// Mass, centre of mass and inertia tensor of a solid of even density; principal axes of a tensor.
#pragma once

#include "base/shape.hpp"

namespace animado::controle {

struct MassProperties {
  double mass_kg = 0;
  Vec3 center_of_mass_m = Vec3::Zero();  // body frame
  Mat3 inertia_kg_m2 = Mat3::Zero();     // about the centre of mass, body axes; off the diagonal −∫ xy dm
};

double volume_m3(const Shape& shape);  // of a half-space: infinite

// Exact for every shape but the half-space, which has no mass properties (asserts).
MassProperties mass_properties(const Shape& shape, double density_kg_m3);

struct PrincipalAxes {
  Vec3 moments_kg_m2 = Vec3::Zero();    // ascending
  Quat orientation = Quat::Identity();  // principal axes → body axes, right-handed
};
PrincipalAxes principal_axes(const Mat3& inertia_kg_m2);

// Whether a rigid body can have this tensor: symmetric, positive definite, and no principal moment more than
// the sum of the two others (a flat plate has equality). `why` says what fails.
bool is_inertia(const Mat3& inertia_kg_m2, std::string* why = nullptr);

// The tensor about a point at `offset_m` from the centre of mass (parallel axes): equation (1)'s J, with the
// frame's origin as point.
Mat3 inertia_about(const Mat3& inertia_kg_m2, double mass_kg, const Vec3& offset_m);

}  // namespace animado::controle
