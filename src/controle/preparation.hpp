// From the scene to what stepping needs: inertias, drives, paths, and colisao's records of the bodies.
#pragma once

#include <vector>

#include "colisao/protocol.hpp"
#include "controle/equations_of_motion.hpp"
#include "controle/forces.hpp"
#include "controle/kinematics.hpp"
#include "controle/scene/scene.hpp"
#include "controle/scene/scope.hpp"

namespace animado::controle {

// By column of the state. Bodies that are not dynamic have unit inertia: equation (1) leaves them where they
// are.
std::vector<Inertia> inertias(const Scene& scene);

// The dynamic bodies with forces, torques or damping of their own, their expressions compiled.
std::vector<Drive> drives(const Scene& scene, const SceneScope& scope);

std::vector<Path> paths(const Scene& scene, const SceneScope& scope);

colisao::Prepare::Request colliders(const Scene& scene);

}  // namespace animado::controle
