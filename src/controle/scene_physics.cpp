#include "controle/scene_physics.hpp"

namespace animado::controle {

std::vector<BodyPhysics> physics_of(const Scene& scene) {
  std::vector<BodyPhysics> bodies;
  for (const Body& body : scene.bodies) {
    bodies.push_back({body.shape, body.motion, body.mass_kg, body.center_of_mass_m, body.inertia_kg_m2,
                      body.restitution, body.friction});
  }
  return bodies;
}

std::string combination_of(RestitutionRule rule) {
  switch (rule) {
    case RestitutionRule::product:
      return "multiply";
    case RestitutionRule::min:
      return "minimum";
    case RestitutionRule::max:
      return "maximum";
    case RestitutionRule::mean:
      break;
  }
  return "average";
}

}  // namespace animado::controle
