// Which unknowns are positions and which momenta, so that a symplectic method can move them in turn.
#pragma once

#include <vector>

namespace animado::fred {

class Equations;

// position[i]: unknown i is a position. Right-hand sides of positions use momenta and t alone, those of
// momenta positions and t alone; of unknowns that are linked so, the first one written is a position. Throws
// refused, and names an equation, where there is no such division.
std::vector<bool> positions_of(const Equations& equations);

}  // namespace animado::fred
