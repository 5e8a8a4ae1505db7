// A body as the geometry sees it: what it is, whether it moves, whom it may meet.
#pragma once

#include <string>
#include <vector>

#include "colisao/solid.hpp"

namespace animado::colisao {

struct Collider {
  Solid solid;
  Motion motion = Motion::dynamic;
  std::string group;
  std::vector<std::string> collides_with;  // groups; empty means all
};

// Two bodies of which neither is dynamic never meet; otherwise each must allow the other's group.
bool may_meet(const Collider& a, const Collider& b);

}  // namespace animado::colisao
