// What the bodies of an animation are as solids, so that a physics engine can take over where the animation
// ends: the glTF extensions KHR_physics_rigid_bodies and KHR_implicit_shapes. Both are DRAFTS, read in 2026
// from the pull requests of their authors: names and meanings may change, and hence they are written only on
// request. A file says that it uses them, not that it needs them: who does not know them sees the animation.
#pragma once

#include <span>
#include <string>

#include "base/shape.hpp"
#include "base/state.hpp"

namespace tinygltf {
class Model;
}

namespace animado::controle {

struct BodyPhysics {
  Shape shape = Sphere{1};
  Motion motion = Motion::dynamic;
  double mass_kg = 0;
  Vec3 center_of_mass_m = Vec3::Zero();  // body frame
  Mat3 inertia_kg_m2 = Mat3::Zero();     // about the centre of mass, body axes
  double restitution = 0, friction = 0;
  BodyState start = {};
};

// Adds the bodies to their nodes, which are the first of the model, in order. A shape that the drafts have
// only in another place, as a cone or an inclined plane, gets a child node, "NAME collider".
// restitution_combine: how two bodies' restitutions become one: multiply, minimum, maximum or average.
void add_physics(tinygltf::Model& model, std::span<const BodyPhysics> bodies,
                 const std::string& restitution_combine);

}  // namespace animado::controle
