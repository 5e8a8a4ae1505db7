// The contact points of two solids that touch, each with the collision plane by the paper's rules
// (section 3.4.2).
#pragma once

#include <vector>

#include "colisao/contact.hpp"
#include "colisao/solid.hpp"

namespace animado::colisao {

// Appends the contacts of the pair (ia < ib), those with gap ≤ margin; nothing when the solids are farther
// apart. At least one when their gap is at most the margin. Faces that meet give the corners of their common
// region, an edge on a face or along an edge its two ends. A symmetric pose gives symmetric points.
void manifold(int ia, const Solid& a, const Pose& pose_a, int ib, const Solid& b, const Pose& pose_b,
              double margin_m, std::vector<Contact>& out);

}  // namespace animado::colisao
