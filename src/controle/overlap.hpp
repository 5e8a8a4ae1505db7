// The last check of a scene, for which its shapes must meet: nothing overlaps at the start.
#pragma once

#include "controle/scene/scene.hpp"
#include "rpc/channel.hpp"

namespace animado::controle {

// Throws Error refused, with the place of the second object's position, when two objects overlap by more than
// 1e-6 m; touching is fine. Asks the suite's colisao.
void refuse_overlap(const Scene& scene, rpc::Suite& suite);

}  // namespace animado::controle
