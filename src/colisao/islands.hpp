// Which bodies can feel each other: the connected components of the contacts through dynamic bodies. What
// nothing can push carries nothing on: two stacks on one floor are two islands.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "colisao/bodies.hpp"

namespace animado::colisao {

struct Island {
  std::vector<int> bodies;  // dynamic ones, ascending
  std::vector<int> links;   // indices of the pairs (or contacts) that it was made of, ascending
};

// links: pairs of bodies; a pair of two immovable bodies belongs to no island. Islands in the order of their
// lowest body; bodies without a link are in none.
std::vector<Island> islands(const std::vector<bool>& is_dynamic, std::span<const std::pair<int, int>> links);

}  // namespace animado::colisao
